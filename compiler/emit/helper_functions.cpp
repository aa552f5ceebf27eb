#include "compiler/emit/helper_functions.h"

#include <taskc/largest_reward.h>

#include <array>

// The number as it is written.
#define TEXT_OF_WORD(word) #word
#define TEXT_OF(macro) TEXT_OF_WORD(macro)

namespace compiler {
namespace {

struct HelperDescription {
  Helper helper;
  std::string_view name;
  std::string_view text;
};

// Functions of the library are declared under names of our own: a C++ compiler that knows what it
// is calling computes calls with constant arguments by itself, with other last bits than the
// library's, and so lets the result depend on how well it optimizes.
constexpr std::array<HelperDescription, kHelperCount> kHelpers{{
    {Helper::kExp, "Exp",
     R"(extern "C" double Exp(double) __asm__("exp") __attribute__((const));)"},
    {Helper::kLog, "Log",
     R"(extern "C" double Log(double) __asm__("log") __attribute__((const));)"},
    {Helper::kTanh, "Tanh",
     R"(extern "C" double Tanh(double) __asm__("tanh") __attribute__((const));)"},
    {Helper::kSin, "Sin",
     R"(extern "C" double Sin(double) __asm__("sin") __attribute__((const));)"},
    {Helper::kCos, "Cos",
     R"(extern "C" double Cos(double) __asm__("cos") __attribute__((const));)"},
    {Helper::kTan, "Tan",
     R"(extern "C" double Tan(double) __asm__("tan") __attribute__((const));)"},
    {Helper::kAsin, "Asin",
     R"(extern "C" double Asin(double) __asm__("asin") __attribute__((const));)"},
    {Helper::kAcos, "Acos",
     R"(extern "C" double Acos(double) __asm__("acos") __attribute__((const));)"},
    {Helper::kAtan, "Atan",
     R"(extern "C" double Atan(double) __asm__("atan") __attribute__((const));)"},
    {Helper::kPow, "Pow",
     R"(extern "C" double Pow(double, double) __asm__("pow") __attribute__((const));)"},
    {Helper::kAtan2, "Atan2",
     R"(extern "C" double Atan2(double, double) __asm__("atan2") __attribute__((const));)"},
    {Helper::kMin, "Min",
     R"(// The smaller number; not a number where one of them is none, so that no mistake gets lost.
double Min(double a, double b) { return a < b || a != a ? a : b; })"},
    {Helper::kMax, "Max",
     R"(// The larger number; not a number where one of them is none, so that no mistake gets lost.
double Max(double a, double b) { return a > b || a != a ? a : b; })"},
    {Helper::kMinInt, "Min", "long long Min(long long a, long long b) { return a < b ? a : b; }"},
    {Helper::kMaxInt, "Max", "long long Max(long long a, long long b) { return a > b ? a : b; }"},
    {Helper::kSign, "Sign", "double Sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : x; }"},
    {Helper::kSignInt, "Sign",
     "long long Sign(long long x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }"},
    {Helper::kAbsInt, "Abs",
     R"(// The smallest number remains: the compiler's own function would be taken for one that is never below 0.
long long Abs(long long x) { return x < 0 ? (long long)(0ULL - (unsigned long long)x) : x; })"},
    {Helper::kPay, "Pay",
     R"(// Pays a reward term; where that gives no finite reward, or too large a one, reports the term.
void Pay(taskc_frame* frame, double& reward, int term, double value) {
  if (__builtin_fabs(reward + value) <= )" TEXT_OF(TASKC_LARGEST_REWARD) R"() {
    reward += value;
    frame->terms[term] += value;
  } else if (frame->fault < 0) {
    frame->fault = term;
  }
})"},
    {Helper::kEnd, "End",
     R"(// Ends the episode; the first end counts.
void End(taskc_frame* frame, int end) {
  if (frame->end < 0) frame->end = end;
})"},
    {Helper::kNote, "Note",
     R"(// Adds a value to what has been logged in this episode.
void Note(taskc_frame* frame, int log, double value) {
  taskc_log_state& state = frame->logs[log];
  const bool is_first = state.count++ == 0;
  state.last = value;
  state.sum = is_first ? value : state.sum + value;
  state.minimum = is_first ? value : Min(state.minimum, value);
  state.maximum = is_first ? value : Max(state.maximum, value);
})"},
    {Helper::kRequire, "Require",
     R"(// Reports what does not hold; the first requirement counts.
void Require(taskc_frame* frame, int requirement, bool holds) {
  if (!holds && frame->violation < 0) frame->violation = requirement;
})"},
    {Helper::kDrawPlace, "DrawPlace",
     R"(// Where a goal or a start is drawn; see taskc_goal.
struct DrawPlace {
  taskc_uint64 seed;
  taskc_uint32 stream;
  taskc_uint32 draw;
};)"},
    {Helper::kRandomUnit, "RandomUnit",
     R"(// 53 random bits as a number from 0 to below 1: two of the four words of Philox4x32-10.
double RandomUnit(const DrawPlace& place, taskc_uint32 element, taskc_uint32 site, int second) {
  taskc_uint32 key[] = {(taskc_uint32)place.seed, (taskc_uint32)(place.seed >> 32)};
  taskc_uint32 word[] = {place.draw, element, site, place.stream};
  for (int round = 0; round < 10; ++round) {
    const taskc_uint64 a = 0xD2511F53ull * word[0];
    const taskc_uint64 b = 0xCD9E8D57ull * word[2];
    word[0] = (taskc_uint32)(b >> 32) ^ word[1] ^ key[0];
    word[1] = (taskc_uint32)b;
    word[2] = (taskc_uint32)(a >> 32) ^ word[3] ^ key[1];
    word[3] = (taskc_uint32)a;
    key[0] += 0x9E3779B9u;
    key[1] += 0xBB67AE85u;
  }
  return ((word[2 * second] >> 5) * 67108864.0 + (word[2 * second + 1] >> 6)) * 0x1p-53;
})"},
    {Helper::kUniform, "Uniform",
     R"(double Uniform(const DrawPlace& place, taskc_uint32 element, taskc_uint32 site, double low,
               double high) {
  const double number = low + (high - low) * RandomUnit(place, element, site, 0);
  // The sum may have been rounded to beyond the end.
  return (number > high) == (low < high) ? high : number;
})"},
    {Helper::kNormal, "Normal",
     R"(// By the Box-Muller transform.
double Normal(const DrawPlace& place, taskc_uint32 element, taskc_uint32 site, double mean,
              double deviation) {
  const double radius = __builtin_sqrt(-2 * Log(1 - RandomUnit(place, element, site, 0)));
  const double turn = Cos(6.283185307179586 * RandomUnit(place, element, site, 1));
  return mean + deviation * (radius * turn);
})"},
    {Helper::kChoose, "Choose",
     R"(// 0 .. count - 1
int Choose(const DrawPlace& place, taskc_uint32 element, taskc_uint32 site, int count) {
  return (int)(RandomUnit(place, element, site, 0) * count);
})"},
    {Helper::kApproach, "Approach",
     R"(// A share of the way from the past to the present, never beyond it.
double Approach(double past, double now, double share) {
  const double next = past + (now - past) * share;
  return (next > now) == (past < now) ? now : next;
})"},
    {Helper::kLag, "Lag",
     R"(// How many steps back, of those that are remembered.
long long Lag(double steps, double most) { return (long long)(steps < most ? steps : most); })"},
    {Helper::kTable, "Table",
     R"(// Rows of numbers for increasing arguments.
struct Table {
  const double* arguments;
  const double* elements;
  int rows;
  int columns;
};
// A row and the next one, and how far from one to the other.
struct TablePlace {
  int from;
  int to;
  double share;
};)"},
    {Helper::kInFirstRound, "InFirstRound",
     R"(// The argument that means the same where a table repeats itself.
double InFirstRound(const Table& table, double argument) {
  const double first = table.arguments[0];
  const double length = table.arguments[table.rows - 1] - first;
  const double passed = argument - first;
  if (passed >= 0 && passed < length) return first + passed;
  return first + (passed - __builtin_floor(passed / length) * length);
})"},
    {Helper::kFindPlace, "FindPlace",
     R"(// Before the first and after the last row these hold. Rows are mostly as far from each other: where
// the guess is wrong, the range that is left is halved.
TablePlace FindPlace(const Table& table, double argument) {
  const double* at = table.arguments;
  const int last = table.rows - 1;
  if (argument >= at[last]) return {last, last, 0};
  if (!(argument > at[0])) return {0, 0, argument == argument ? 0 : argument};
  int row = (int)((argument - at[0]) / (at[last] - at[0]) * last);
  if (row >= last) row = last - 1;
  if (argument < at[row] || argument >= at[row + 1]) {
    int end = last;
    for (row = 0; end - row > 1;) {
      const int middle = row + (end - row) / 2;
      if (argument < at[middle]) {
        end = middle;
      } else {
        row = middle;
      }
    }
  }
  return {row, row + 1, (argument - at[row]) / (at[row + 1] - at[row])};
})"},
    {Helper::kBetween, "Between",
     R"(// Never beyond the end, however the sum is rounded.
double Between(double from, double to, double share) {
  const double value = from + (to - from) * share;
  return from < to ? (value > to ? to : value) : (value < to ? to : value);
})"},
    {Helper::kReadTable, "ReadTable",
     R"(double ReadTable(const Table& table, const TablePlace& place, int column) {
  const double from = table.elements[place.from * table.columns + column];
  const double to = table.elements[place.to * table.columns + column];
  return from + (to - from) * place.share;
})"},
    {Helper::kReadHeld, "ReadHeld",
     R"(// Of a column in which the sum would be rounded to beyond the next row.
double ReadHeld(const Table& table, const TablePlace& place, int column) {
  return Between(table.elements[place.from * table.columns + column],
                 table.elements[place.to * table.columns + column], place.share);
})"},
    {Helper::kReadRotations, "ReadRotations",
     R"(void ReadRotations(const Table& table, const TablePlace& place, double* rotations) {
  const double* from = table.elements + place.from * table.columns;
  const double* to = table.elements + place.to * table.columns;
  for (int i = 0; i < table.columns; i += 4) {
    double* rotation = rotations + i;
    double square = 0;
    for (int k = 0; k < 4; ++k) {
      rotation[k] = Between(from[i + k], to[i + k], place.share);
      square += rotation[k] * rotation[k];
    }
    const double length = __builtin_sqrt(square);
    for (int k = 0; k < 4; ++k) rotation[k] /= length;
  }
})"},
    {Helper::kLastGrowth, "LastGrowth",
     R"(// What a potential pays when the episode is over; at a terminal end it is 0.
double LastGrowth(const taskc_frame* frame, bool is_paid, double last, double now) {
  const bool is_terminal = frame->outcome == TASKC_SUCCESS || frame->outcome == TASKC_FAILURE;
  if (is_paid) return is_terminal ? 0.0 - frame->discount * last : 0.0;
  return is_terminal ? 0.0 - last : frame->discount * now - last;
})"},
}};

constexpr bool IsInOrder() {
  for (int i = 0; i < kHelperCount; ++i) {
    if (kHelpers[static_cast<size_t>(i)].helper != static_cast<Helper>(i)) return false;
  }
  return true;
}
static_assert(IsInOrder());

const HelperDescription& Describe(Helper helper) { return kHelpers[static_cast<size_t>(helper)]; }

}  // namespace

std::string_view HelperName(Helper helper) { return Describe(helper).name; }
std::string_view HelperText(Helper helper) { return Describe(helper).text; }

}  // namespace compiler
