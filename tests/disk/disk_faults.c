// A disk that fails, or that is remembered, for a program that is started with
// LD_PRELOAD=disk_faults.so.
//
//   DISK_FOLDER=DIR    what is in there is on that disk; everything else is left alone
//   DISK_FAULT=NAME    ENOSPC, EROFS: the DISK_AT-th change and all after it fail so; EIO: that one
//   does DISK_AT=N          counted over all changes of one process, from 1 DISK_LOG=FILE every
//   change is written there, in its order, for power_cut.py
//
// Changes are: make, write, truncate, sync, rename, remove. What is mapped into memory is not seen.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

static char folder[PATH_MAX];
static size_t folder_length;
static int fault, fault_is_once, log_file = -1;
static long fault_at, changes;
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;

__attribute__((constructor)) static void begin(void) {
  const char* named = getenv("DISK_FOLDER");
  if (named == NULL || realpath(named, folder) == NULL) return;
  folder_length = strlen(folder);
  const char* kind = getenv("DISK_FAULT");
  if (kind != NULL) {
    fault = strcmp(kind, "ENOSPC") == 0 ? ENOSPC : strcmp(kind, "EROFS") == 0 ? EROFS : EIO;
    fault_is_once = fault == EIO;
    fault_at = atol(getenv("DISK_AT"));
  }
  const char* log = getenv("DISK_LOG");
  if (log != NULL) {
    log_file =
        (int)syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  }
}

static int is_inside(const char* path) {
  return folder_length > 0 && strncmp(path, folder, folder_length) == 0 &&
         (path[folder_length] == '/' || path[folder_length] == '\0');
}

// The absolute path of `path`, as far as its folder exists. Returns whether it is on the disk.
static int place_of(int at, const char* path, char* place) {
  char joined[2 * PATH_MAX], parent[PATH_MAX];
  if (path[0] == '/') {
    snprintf(joined, sizeof joined, "%s", path);
  } else {
    char link[64];
    if (at == AT_FDCWD) {
      snprintf(link, sizeof link, "/proc/self/cwd");
    } else {
      snprintf(link, sizeof link, "/proc/self/fd/%d", at);
    }
    const ssize_t size = readlink(link, parent, sizeof parent - 1);
    if (size < 0) return 0;
    parent[size] = '\0';
    snprintf(joined, sizeof joined, "%s/%s", parent, path);
  }
  char* name = strrchr(joined, '/');
  *name++ = '\0';
  if (realpath(joined[0] == '\0' ? "/" : joined, parent) == NULL) return 0;
  snprintf(place, PATH_MAX, "%s/%s", parent, name);
  return is_inside(place);
}

static int place_of_descriptor(int descriptor, char* place) {
  if (folder_length == 0) return 0;
  char link[64];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = readlink(link, place, PATH_MAX - 1);
  if (size <= 0) return 0;
  place[size] = '\0';
  return is_inside(place);
}

// To be called with the mutex held, before each change. Returns whether it is to fail, with errno.
static int fails(void) {
  ++changes;
  if (fault == 0 || (fault_is_once ? changes != fault_at : changes < fault_at)) return 0;
  errno = fault;
  return 1;
}

static void note(const char* what, long inode, long offset, const char* one, const char* other,
                 const void* data, size_t size) {
  if (log_file < 0) return;
  char head[2 * PATH_MAX + 200];
  const int length = snprintf(head, sizeof head, "%s\t%ld\t%ld\t%zu\t%s\t%s\n", what, inode, offset,
                              size, one, other);
  struct iovec parts[] = {{head, (size_t)length}, {(void*)data, size}};
  syscall(SYS_writev, log_file, parts, 2);
}

static long inode_of(int descriptor) {
  struct stat status;
  return fstat(descriptor, &status) == 0 ? (long)status.st_ino : 0;
}

#define LOCK() pthread_mutex_lock(&mutex)
#define UNLOCK()                  \
  do {                            \
    const int kept = errno;       \
    pthread_mutex_unlock(&mutex); \
    errno = kept;                 \
  } while (0)

static int open_at(int at, const char* path, int flags, mode_t mode) {
  char place[PATH_MAX];
  if ((flags & (O_CREAT | O_TRUNC)) == 0 || !place_of(at, path, place)) {
    return (int)syscall(SYS_openat, at, path, flags, mode);
  }
  LOCK();
  const int was_there = access(place, F_OK) == 0;
  int result = -1;
  if ((was_there && (flags & O_TRUNC) == 0) || !fails()) {
    result = (int)syscall(SYS_openat, at, path, flags, mode);
    if (result >= 0 && !was_there) note("make", inode_of(result), 0, place, "", NULL, 0);
    if (result >= 0 && was_there && (flags & O_TRUNC) != 0) {
      note("truncate", inode_of(result), 0, place, "", NULL, 0);
    }
  }
  UNLOCK();
  return result;
}

#define OPEN(name, parameters, at)            \
  int name parameters {                       \
    va_list more;                             \
    va_start(more, flags);                    \
    const mode_t mode = va_arg(more, mode_t); \
    va_end(more);                             \
    return open_at(at, path, flags, mode);    \
  }
OPEN(open, (const char* path, int flags, ...), AT_FDCWD)
OPEN(open64, (const char* path, int flags, ...), AT_FDCWD)
OPEN(openat, (int at, const char* path, int flags, ...), at)
OPEN(openat64, (int at, const char* path, int flags, ...), at)

static ssize_t write_at(int descriptor, const void* data, size_t size, off_t offset,
                        int is_placed) {
  char place[PATH_MAX];
  if (!place_of_descriptor(descriptor, place)) {
    return is_placed ? syscall(SYS_pwrite64, descriptor, data, size, offset)
                     : syscall(SYS_write, descriptor, data, size);
  }
  LOCK();
  ssize_t result = -1;
  if (!fails()) {
    if (!is_placed) offset = lseek(descriptor, 0, SEEK_CUR);
    result = syscall(SYS_pwrite64, descriptor, data, size, offset);
    if (result > 0) {
      if (!is_placed) lseek(descriptor, offset + result, SEEK_SET);
      note("write", inode_of(descriptor), offset, place, "", data, (size_t)result);
    }
  }
  UNLOCK();
  return result;
}

ssize_t write(int descriptor, const void* data, size_t size) {
  return write_at(descriptor, data, size, 0, 0);
}
ssize_t pwrite(int descriptor, const void* data, size_t size, off_t offset) {
  return write_at(descriptor, data, size, offset, 1);
}
ssize_t pwrite64(int descriptor, const void* data, size_t size, off64_t offset) {
  return write_at(descriptor, data, size, offset, 1);
}
ssize_t writev(int descriptor, const struct iovec* parts, int count) {
  char place[PATH_MAX];
  if (!place_of_descriptor(descriptor, place)) {
    return syscall(SYS_writev, descriptor, parts, count);
  }
  ssize_t total = 0;
  for (int i = 0; i < count; ++i) {
    const ssize_t size = write(descriptor, parts[i].iov_base, parts[i].iov_len);
    if (size < 0) return total > 0 ? total : size;
    total += size;
    if ((size_t)size < parts[i].iov_len) break;
  }
  return total;
}

static int sync_file(int descriptor, long call) {
  char place[PATH_MAX];
  if (!place_of_descriptor(descriptor, place)) return (int)syscall(call, descriptor);
  LOCK();
  int result = -1;
  if (!fails()) {
    result = 0;  // what the disk would have is known from the log; this is only faster
    note("sync", inode_of(descriptor), 0, place, "", NULL, 0);
  }
  UNLOCK();
  return result;
}
int fsync(int descriptor) { return sync_file(descriptor, SYS_fsync); }
int fdatasync(int descriptor) { return sync_file(descriptor, SYS_fdatasync); }

int ftruncate(int descriptor, off_t size) {
  char place[PATH_MAX];
  if (!place_of_descriptor(descriptor, place)) return (int)syscall(SYS_ftruncate, descriptor, size);
  LOCK();
  int result = -1;
  if (!fails()) {
    result = (int)syscall(SYS_ftruncate, descriptor, size);
    if (result == 0) note("truncate", inode_of(descriptor), size, place, "", NULL, 0);
  }
  UNLOCK();
  return result;
}
int ftruncate64(int descriptor, off64_t size) { return ftruncate(descriptor, size); }

static int rename_at(int from_at, const char* from, int to_at, const char* to) {
  char place[PATH_MAX], other[PATH_MAX];
  const int is_ours = place_of(from_at, from, place) & place_of(to_at, to, other);
  if (!is_ours) return (int)syscall(SYS_renameat2, from_at, from, to_at, to, 0);
  LOCK();
  int result = -1;
  if (!fails()) {
    result = (int)syscall(SYS_renameat2, from_at, from, to_at, to, 0);
    if (result == 0) note("rename", 0, 0, place, other, NULL, 0);
  }
  UNLOCK();
  return result;
}
int rename(const char* from, const char* to) { return rename_at(AT_FDCWD, from, AT_FDCWD, to); }
int renameat(int from_at, const char* from, int to_at, const char* to) {
  return rename_at(from_at, from, to_at, to);
}

static int unlink_at(int at, const char* path, int flags) {
  char place[PATH_MAX];
  if ((flags & AT_REMOVEDIR) != 0 || !place_of(at, path, place)) {
    return (int)syscall(SYS_unlinkat, at, path, flags);
  }
  LOCK();
  int result = -1;
  if (access(place, F_OK) != 0) {
    errno = ENOENT;
  } else if (!fails()) {
    result = (int)syscall(SYS_unlinkat, at, path, flags);
    if (result == 0) note("remove", 0, 0, place, "", NULL, 0);
  }
  UNLOCK();
  return result;
}
int unlink(const char* path) { return unlink_at(AT_FDCWD, path, 0); }
int unlinkat(int at, const char* path, int flags) { return unlink_at(at, path, flags); }
int remove(const char* path) {
  struct stat status;
  const int is_folder = lstat(path, &status) == 0 && S_ISDIR(status.st_mode);
  return unlink_at(AT_FDCWD, path, is_folder ? AT_REMOVEDIR : 0);
}
