// What a person waits for while typing: an answer of the language server, and the mistakes after a
// change.
#include <benchmark/benchmark.h>

#include "compiler/language_server/language_server.h"
#include "compiler/source/file_reader.h"

namespace compiler {
namespace {

using protocol::Json;

constexpr const char* kUri = "file://" SOURCE_DIR "/tasks/crawling.task";

// An editor with the crawling task open.
LanguageServer& Server() {
  static LanguageServer server = [] {
    LanguageServer started({.robots = SOURCE_DIR "/plugins", .diagnostics_page = ""});
    started.Receive(R"({"id": 1, "method": "initialize", "params": {"capabilities": {}}})");
    const Json text = MustReadFromDisk(SOURCE_DIR "/tasks/crawling.task");
    started.Receive(Json{{"method", "textDocument/didOpen"},
                         {"params", {{"textDocument", {{"uri", kUri}, {"text", text}}}}}}
                        .dump());
    started.Report();
    return started;
  }();
  return server;
}

std::string Question(const std::string& method, int line, int character) {
  return Json{{"id", 1},
              {"method", method},
              {"params",
               {{"textDocument", {{"uri", kUri}}},
                {"position", {{"line", line}, {"character", character}}}}}}
      .dump();
}

// Types a blank at the file's end.
void Type() {
  static const std::string change = Json{
      {"method", "textDocument/didChange"},
      {"params",
       {{"textDocument", {{"uri", kUri}}},
        {"contentChanges",
         {{{"range",
            {{"start", {{"line", 0}, {"character", 4}}}, {"end", {{"line", 0}, {"character", 5}}}}},
           {"text", "M"}}}}}}}.dump();
  Server().Receive(change);
}

void Diagnose(benchmark::State& state) {
  for (auto _ : state) {
    Type();
    benchmark::DoNotOptimize(Server().Report());
  }
}
BENCHMARK(Diagnose)->Unit(benchmark::kMillisecond);

// After each keystroke, so that nothing is known yet.
void CompleteWhileTyping(benchmark::State& state) {
  const std::string question = Question("textDocument/completion", 18, 50);
  for (auto _ : state) {
    Type();
    benchmark::DoNotOptimize(Server().Receive(question));
  }
}
BENCHMARK(CompleteWhileTyping)->Unit(benchmark::kMillisecond);

void Hover(benchmark::State& state) {
  const std::string question = Question("textDocument/hover", 22, 10);
  for (auto _ : state) benchmark::DoNotOptimize(Server().Receive(question));
}
BENCHMARK(Hover)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace compiler

BENCHMARK_MAIN();
