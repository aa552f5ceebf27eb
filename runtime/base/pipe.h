#pragma once

namespace runtime {

// A pipe of which no program that is started gets an end by itself. What is written to its input
// comes out of its output.
class Pipe {
 public:
  // Throws UserError.
  Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe();

  int input() const { return input_; }
  int output() const { return output_; }
  void CloseInput();
  void CloseOutput();
  // From now on the caller's to close.
  int TakeInput();
  int TakeOutput();

 private:
  int input_ = -1;
  int output_ = -1;
};

}  // namespace runtime
