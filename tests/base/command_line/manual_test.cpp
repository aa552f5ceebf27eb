#include "base/command_line/manual.h"

#include <gmock/gmock.h>

#include "base/command_line/roff.h"

namespace command_line {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Key;

class ManualTest : public testing::Test {
 protected:
  ManualTest() {
    program_.ExitStatus("0 done.");
    Command& train = program_.AddCommand("train", "Trains a robot.");
    train.AddOption("TASK", task_, "a task").Required();
    train.AddOption("MORE", more_, "other tasks");
    Option json = train.AddFlag("--json", json_, "print JSON");
    train.AddOption("-n,--runs", runs_, "how many").Range(1, 9).ShowDefault().Excludes(json);
    train.AddOption("--old", name_, "").Hidden();
    train.Examples("robots train x.task  # one run\nrobots train -n 2 x.task");
    train.Environment("HOME.");

    Command& look = program_.AddCommand("look", "looks at runs");
    look.Group("Before");
    look.Notes("Patience.\n  robots look NAME VALUE\nAs `-1`.");
    look.AddOption("--name", name_, "whose").Required().ValueName("NAME");
    Command& change = program_.AddCommand("change", "changes a run");
    change.Group("After");
    Command& more = program_.AddCommand("wait", "waits");
    more.Group("Before");
    change.AddCommand("back", "the old one");
  }

  std::string Page(const std::string& file) const {
    return ManualPages(program_, "robots 1.0", "taskc").at(file);
  }

  std::string task_, name_;
  std::vector<std::string> more_;
  int runs_ = 3;
  bool json_ = false;
  Command program_{"robots", "Trains robots."};
};

TEST_F(ManualTest, HasAPageForEachCommand) {
  EXPECT_THAT(ManualPages(program_, "robots 1.0", "taskc"),
              ElementsAre(Key("robots-change-back.1"), Key("robots-change.1"), Key("robots-look.1"),
                          Key("robots-train.1"), Key("robots-wait.1"), Key("robots.1")));
}

TEST_F(ManualTest, SaysWhatTheHelpSays) {
  EXPECT_EQ(Page("robots-train.1"), R"(.TH ROBOTS\-TRAIN 1 "" "robots 1.0" "Manual of robots"
.SH "NAME"
robots\-train \- Trains a robot
.SH "SYNOPSIS"
\fBrobots train\fR [\fIOPTIONS\fR] \fITASK\fR [\fIMORE\fR...]
.SH "DESCRIPTION"
Trains a robot.
.SH "ARGUMENTS"
.TP
\fITASK\fR
a task
.TP
\fIMORE\fR
other tasks
.SH "OPTIONS"
.TP
\fB\-h\fR, \fB\-\-help\fR
Print this help message and exit
.TP
\fB\-\-json\fR
print JSON (not with \fB\-\-runs\fR)
.TP
\fB\-n\fR, \fB\-\-runs\fR \fIINT\fR
how many (in [1, 9]; by default \fB3\fR; not with \fB\-\-json\fR)
.SH "EXAMPLES"
.RS 2
.nf
robots train x.task  # one run
robots train \-n 2 x.task
.fi
.RE
.SH "ENVIRONMENT"
HOME.
.SH "EXIT STATUS"
0 done.
.SH "SEE ALSO"
\fBrobots\fR(1), \fBtaskc\fR(1)
)");
}

TEST_F(ManualTest, ListsCommandsByTheirGroups) {
  EXPECT_THAT(Page("robots.1"), HasSubstr(R"(.SH "COMMANDS"
.TP
\fBtrain\fR
Trains a robot.
See \fBrobots\-train\fR(1).
.SS "Before"
.TP
\fBlook\fR
Looks at runs.
See \fBrobots\-look\fR(1).
.TP
\fBwait\fR
Waits.
See \fBrobots\-wait\fR(1).
.SS "After"
)"));
  EXPECT_THAT(Page("robots-change-back.1"),
              HasSubstr("\\fBrobots\\fR(1), \\fBrobots\\-change\\fR(1), \\fBtaskc\\fR(1)"));
}

TEST_F(ManualTest, ShowsNotesWithTheirCalls) {
  EXPECT_THAT(Page("robots-look.1"), HasSubstr(R"(.PP
Patience.
.RS 2
.nf
robots look NAME VALUE
.fi
.RE
As \fB\-1\fR.
)"));
  EXPECT_THAT(Page("robots-look.1"), HasSubstr("whose (required)"));
}

TEST(Roff, ShowsSignsAsTheyAre) {
  EXPECT_EQ(RoffText(".a 'b' \\c\n.d ^~ e ` f"),
            "\\&.a \\(aqb\\(aq \\(rsc\n\\&.d \\(ha\\(ti e \\(ga f");
  EXPECT_EQ(RoffText("2 \xE2\x86\x92 3"), "2 \\[u2192] 3");
  EXPECT_EQ(RoffText("`.x`"), "\\fB.x\\fR");
}

}  // namespace
}  // namespace command_line
