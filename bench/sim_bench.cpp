// What environments cost through libtaskc_sim, crawling by random decisions in `fast-tree`:
//   Step     64 environments, by so many threads; items are decisions of one robot, each of which
//            is 8 time steps (40 ms)
//   Picture  of 256 by 256 pixels
#include <benchmark/benchmark.h>
#include <taskc/sim.h>

#include <random>
#include <stdexcept>
#include <vector>

namespace {

constexpr taskc_uint32 kCount = 64;

void Check(taskc_status status) {
  if (status != TASKC_OK) throw std::runtime_error(taskc_sim_error());
}

class Crawlers {
 public:
  Crawlers(taskc_uint32 count, taskc_uint32 threads) {
    taskc_sim_options options;
    taskc_sim_defaults(&options, sizeof options);
    options.plugin = PLUGIN_FOLDER "/crawling.so";
    options.profile = "fast-tree";
    options.count = count;
    options.threads = threads;
    Check(taskc_sim_new(&options, &sim_));
    const taskc_sim_description& about = *taskc_sim_describe(sim_);
    actions_.resize(size_t{count} * about.action_size);
    observations_.resize(size_t{count} * about.observation_size);
    rewards_.resize(count);
    terminated_.resize(count);
    truncated_.resize(count);
    Check(taskc_sim_reset(sim_, nullptr, nullptr, observations_.data()));
  }
  ~Crawlers() { taskc_sim_delete(sim_); }
  Crawlers(const Crawlers&) = delete;
  Crawlers& operator=(const Crawlers&) = delete;

  taskc_sim* sim() const { return sim_; }

  void Decide() {
    std::uniform_real_distribution<float> uniform(-0.5F, 0.5F);
    for (float& element : actions_) element = uniform(random_);
  }
  void Step() {
    const taskc_sim_arrays arrays = {
        observations_.data(), nullptr, rewards_.data(), terminated_.data(),
        truncated_.data(),    nullptr, nullptr};
    Check(taskc_sim_step(sim_, actions_.data(), &arrays));
  }

 private:
  taskc_sim* sim_ = nullptr;
  std::mt19937 random_{1};
  std::vector<float> actions_;
  std::vector<float> observations_;
  std::vector<double> rewards_;
  std::vector<unsigned char> terminated_;
  std::vector<unsigned char> truncated_;
};

void Step(benchmark::State& state) {
  Crawlers crawlers(kCount, static_cast<taskc_uint32>(state.range(0)));
  for (auto _ : state) {
    crawlers.Decide();
    crawlers.Step();
  }
  state.SetItemsProcessed(state.iterations() * int64_t{kCount});
}
BENCHMARK(Step)->Arg(1)->Arg(2)->UseRealTime()->MeasureProcessCPUTime();

void Picture(benchmark::State& state) {
  constexpr taskc_uint32 kSize = 256;
  Crawlers crawlers(1, 1);
  std::vector<unsigned char> rgb(size_t{kSize} * kSize * 3);
  for (auto _ : state) Check(taskc_sim_render(crawlers.sim(), 0, kSize, rgb.data()));
}
BENCHMARK(Picture);

}  // namespace

BENCHMARK_MAIN();
