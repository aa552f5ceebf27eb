// A library that was made for another version of the interface.
extern "C" {
struct {
  int interface;
  const char* compiler;
  void* add;
} taskc_modules = {0, "another", nullptr};
}
