// A process that works on one run, and the lines that it prints.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

// What is read from a pipe, cut into lines.
class LineReader {
 public:
  explicit LineReader(int descriptor) : descriptor_(descriptor) {}
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  ~LineReader() { Close(); }

  int descriptor() const { return descriptor_; }  // -1 at the end
  // Reads what is there, at least one byte or the end, and calls `line` for every whole line.
  void Read(const std::function<void(std::string_view)>& line);

 private:
  void Close();

  int descriptor_;
  std::string rest_;
};

// This program with other words. The process ends when the program that started it ends.
class Worker {
 public:
  // `words`: what stands behind the program's name. Throws UserError where no process can be
  // started.
  explicit Worker(const std::vector<std::string>& words);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker();  // kills it if it still runs

  LineReader& output() { return output_; }
  LineReader& errors() { return errors_; }
  // Both pipes are at their end: it has ended or is about to.
  bool is_silent() const { return output_.descriptor() < 0 && errors_.descriptor() < 0; }

  void Send(int signal) const;
  // Waits for its end; as waitpid() gives it.
  int WaitStatus();

 private:
  struct Pipes;
  Worker(const std::vector<std::string>& words, Pipes pipes);

  pid_t process_;
  LineReader output_;
  LineReader errors_;
};

}  // namespace runtime
