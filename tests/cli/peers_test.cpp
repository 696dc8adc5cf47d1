// SPDX-License-Identifier: GPL-3.0-or-later
// `./scree bench render --peers` where no other renderer is installed.
#include "tests/cli/cli_fixture.h"

#include <cstdio>

namespace scree {
namespace {

using tests::Outcome;

class PeersCli : public tests::CliTest {
  protected:
    Outcome bench(const std::string& arguments) const {
        return run_program(SCREE_RENDER_BENCH, arguments, "PATH=/nowhere");
    }
};

TEST_F(PeersCli, HelpNamesTheScenes) {
    const Outcome help = bench("--peers --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_NE(help.out.find("--quick"), std::string::npos);
    EXPECT_NE(help.out.find("bunnies toys glass lamps room fibres"), std::string::npos);
}

TEST_F(PeersCli, UnknownOptionsAndScenesAreNamed) {
    for (const std::string wrong : {"--quik", "cornell"}) {
        const Outcome refused = bench("--peers glass " + wrong);
        EXPECT_EQ(refused.code, 2);
        EXPECT_EQ(refused.out, "");
        EXPECT_NE(refused.err.find("there is no option or scene " + wrong), std::string::npos);
    }
    EXPECT_EQ(bench("--peer").code, 2);
}

TEST_F(PeersCli, WithoutBlenderSaysSoAndMeasuresScree) {
    const Outcome alone = bench("--peers --quick glass");
    EXPECT_EQ(alone.code, 0) << alone.err;
    EXPECT_NE(alone.out.find("blender is not installed"), std::string::npos);
    const std::size_t row = alone.out.find("\nglass ");
    ASSERT_NE(row, std::string::npos) << alone.out;
    double seconds = 0;
    double error = 0;
    char dash = 0;
    ASSERT_EQ(std::sscanf(alone.out.c_str() + row, " glass %lf %lf %c", &seconds, &error, &dash), 3)
        << alone.out;
    EXPECT_GT(seconds, 0);
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1);
    EXPECT_EQ(dash, '-');
}

} // namespace
} // namespace scree
