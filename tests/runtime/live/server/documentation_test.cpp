// docs/api.md says of the commands what their table says.
#include "runtime/live/control/command_table.h"
#include "tests/runtime/live/server/command_rows.h"

namespace runtime {
namespace {

TEST(Documentation, ListsEveryCommandAndArgument) { ExpectListed(API_PAGE, Commands()); }

}  // namespace
}  // namespace runtime
