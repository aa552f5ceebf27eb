#include "runtime/base/system_call_filter.h"

#include <fmt/format.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

#if defined(__x86_64__)
constexpr uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr uint32_t kArchitecture = 0;
#endif

// What no training needs. Those by a path would reach files that Landlock does not watch.
constexpr uint32_t kRefused[] = {
    __NR_execve,
    __NR_execveat,
    __NR_truncate,
    __NR_fchmodat,
    __NR_fchownat,
    __NR_setxattr,
    __NR_lsetxattr,
    __NR_removexattr,
    __NR_lremovexattr,
#ifdef __NR_chmod
    __NR_chmod,
    __NR_chown,
    __NR_lchown,
#endif
#if !defined(__SANITIZE_ADDRESS__)  // its search for leaks traces the process itself
    __NR_ptrace,
#endif
    __NR_process_vm_readv,
    __NR_process_vm_writev,
    __NR_pidfd_getfd,
    __NR_pidfd_send_signal,
    __NR_rt_sigqueueinfo,
    __NR_rt_tgsigqueueinfo,
    __NR_tkill,
    __NR_io_uring_setup,  // it makes system calls that no filter sees
    __NR_io_uring_enter,
    __NR_io_uring_register,
    __NR_open_by_handle_at,
    __NR_bpf,
    __NR_perf_event_open,
    __NR_userfaultfd,
    __NR_add_key,
    __NR_request_key,
    __NR_keyctl,
    __NR_mount,
    __NR_umount2,
    __NR_pivot_root,
    __NR_chroot,
    __NR_setns,
    __NR_unshare,
    __NR_init_module,
    __NR_finit_module,
    __NR_delete_module,
    __NR_kexec_load,
    __NR_reboot,
};

constexpr uint32_t kLoad = BPF_LD | BPF_W | BPF_ABS;
constexpr uint32_t kIfEqual = BPF_JMP | BPF_JEQ | BPF_K;

class FilterProgram {
 public:
  FilterProgram() {
    Load(offsetof(seccomp_data, arch));
    If(kArchitecture, 1, 0);
    Refuse();  // the calls of another architecture have other numbers
    Load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
    constexpr uint32_t kFirstX32 = 0x40000000;
    Add(BPF_JMP | BPF_JGE | BPF_K, kFirstX32, 0, 1);
    Refuse();
#endif
  }

  void RefuseCall(uint32_t call) {
    If(call, 0, 1);
    Refuse();
  }
  // Unless its argument `index` is `value`.
  void RefuseUnless(uint32_t call, int index, uint32_t value) {
    DecideBy(call, index, value, 1, 0);
  }
  // Where its argument `index` is `value`.
  void RefuseIf(uint32_t call, int index, uint32_t value) { DecideBy(call, index, value, 0, 1); }
  void AllowOnlyUnixStreams() {
    constexpr uint32_t kTypeMask = 0xf;  // the rest are flags
    If(__NR_socket, 0, 7);
    LoadArgument(0);
    If(AF_UNIX, 0, 3);
    LoadArgument(1);
    Add(BPF_ALU | BPF_AND | BPF_K, kTypeMask);
    If(SOCK_STREAM, 1, 0);
    Refuse();
    Allow();
  }
  void Enforce() {
    Allow();
    const sock_fprog program{static_cast<unsigned short>(steps_.size()), steps_.data()};
    // Without SPEC_ALLOW, kernels before 5.16 slow down the whole process.
    constexpr unsigned kFlags = SECCOMP_FILTER_FLAG_TSYNC | SECCOMP_FILTER_FLAG_SPEC_ALLOW;
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, kFlags, &program) == 0) return;
    throw UserError(
        fmt::format("the sandbox cannot filter system calls: {}; `--no-sandbox` does without it",
                    std::strerror(errno)));
  }

 private:
  void Add(uint32_t code, uint32_t value, uint8_t if_true = 0, uint8_t if_false = 0) {
    steps_.push_back({static_cast<uint16_t>(code), if_true, if_false, value});
  }
  void Load(size_t offset) { Add(kLoad, static_cast<uint32_t>(offset)); }
  // Its lower half: what is looked at has 32 bits.
  void LoadArgument(int index) {
    Load(offsetof(seccomp_data, args) + static_cast<size_t>(index) * sizeof(uint64_t));
  }
  // How many steps to leave out.
  void If(uint32_t value, uint8_t if_true, uint8_t if_false) {
    Add(kIfEqual, value, if_true, if_false);
  }
  // Refuses the call, or leaves out that step.
  void DecideBy(uint32_t call, int index, uint32_t value, uint8_t if_equal, uint8_t if_not) {
    If(call, 0, 4);
    LoadArgument(index);
    If(value, if_equal, if_not);
    Refuse();
    Allow();
  }
  void Refuse() { Add(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM); }
  void Allow() { Add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW); }

  std::vector<sock_filter> steps_;
};

}  // namespace

bool HasSystemCallFilter() {
  constexpr uint32_t kWanted = SECCOMP_RET_ERRNO;
  return kArchitecture != 0 && syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &kWanted) == 0;
}

void RestrictSystemCalls(bool may_connect) {
  if (!HasSystemCallFilter()) return;
  FilterProgram program;
  for (const uint32_t call : kRefused) program.RefuseCall(call);
  if (!may_connect) program.RefuseCall(__NR_connect);
  const auto self = static_cast<uint32_t>(getpid());
  program.RefuseUnless(__NR_kill, 0, self);
  program.RefuseUnless(__NR_tgkill, 0, self);
  program.RefuseIf(__NR_ioctl, 1, TIOCSTI);
  program.AllowOnlyUnixStreams();
  program.Enforce();
}

}  // namespace runtime
