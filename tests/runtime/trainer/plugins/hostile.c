// A task that tries what no task should, while it is loaded and in its first time step, and says on
// the standard error stream what it could do.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/runtime/core/task/plugins/plugin_table.h"

static int can_read(const char* name) {
  const int file = open(name, O_RDONLY);
  if (file >= 0) close(file);
  return file >= 0;
}

static int can_write(const char* name) {
  const int file = open(name, O_WRONLY | O_CREAT, 0666);
  if (file >= 0) close(file);
  return file >= 0;
}

static int can_connect(int family, int type, const void* address, socklen_t size) {
  const int client = socket(family, type, 0);
  const int result = client >= 0 && connect(client, address, size) == 0;
  if (client >= 0) close(client);
  return result;
}

static int can_execute(void) {
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/true", "true", (char*)NULL);
    _exit(1);
  }
  int status = 1;
  waitpid(child, &status, 0);
  return child > 0 && status == 0;
}

static void attempt(const char* when) {
  const char* home = getenv("HOME");
  const char* port = getenv("HOSTILE_PORT");
  const char* local = getenv("HOSTILE_SOCKET");
  if (home == NULL || port == NULL || local == NULL) return;
  char secret[4096], other[4096];
  snprintf(secret, sizeof secret, "%s/secret", home);
  snprintf(other, sizeof other, "%s/other", home);
  struct sockaddr_in internet = {.sin_family = AF_INET,
                                 .sin_port = htons((unsigned short)atoi(port))};
  internet.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  struct sockaddr_un unix_address = {.sun_family = AF_UNIX};
  strncpy(unix_address.sun_path, local, sizeof unix_address.sun_path - 1);
  fprintf(stderr, "hostile %s:%s%s%s%s%s%s%s%s%s%s\n", when, can_read(secret) ? " read" : "",
          can_write(secret) ? " overwrite" : "", can_write(other) ? " create" : "",
          unlink(secret) == 0 ? " remove" : "", chmod(home, 0777) == 0 ? " chmod" : "",
          can_connect(AF_INET, SOCK_STREAM, &internet, sizeof internet) ? " tcp" : "",
          can_connect(AF_INET, SOCK_DGRAM, &internet, sizeof internet) ? " udp" : "",
          can_connect(AF_UNIX, SOCK_STREAM, &unix_address, sizeof unix_address) ? " unix" : "",
          kill(getppid(), 0) == 0 ? " signal" : "", can_execute() ? " execute" : "");
  fflush(stderr);
}

__attribute__((constructor)) static void on_load(void) { attempt("load"); }

static void end_of_time_step(taskc_frame* frame) {
  taskc_int64* steps = (taskc_int64*)frame->memory;
  if (++*steps == 1) attempt("step");
  if (*steps % 10 == 0) frame->end = 0;
}

static const taskc_memory variables[] = {{"steps", "int", "", TASKC_INT, 1, 1, TASKC_PER_RUN, 0}};

static void initialize(taskc_frame* frame) { *(taskc_int64*)frame->memory = 0; }

static const taskc_end ends[] = {{"time is up", TASKC_TRUNCATED, {0}}};

PLUGIN(.name = "hostile", .robot = "", .memory = variables, .memory_count = 1, .memory_size = 8,
       .initialize = initialize, .ends = ends, .end_count = 1,
       .events = {[TASKC_END_OF_TIME_STEP] = end_of_time_step})
