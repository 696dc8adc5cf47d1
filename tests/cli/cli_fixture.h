// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program in a temporary folder.
#pragma once

#include "core/file.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <sys/wait.h>

namespace scree::tests {

struct Outcome {
    int code = -1;
    std::string out;
    std::string err;
};

class CliTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.file(name); }

    /// Runs the program in the test's folder.
    Outcome run(const std::string& arguments, const std::string& environment = "") const {
        return run_program(SCREE_PROGRAM, arguments, environment);
    }

    /// Runs another program there.
    Outcome run_program(const std::string& program, const std::string& arguments,
                        const std::string& environment = "") const {
        const std::string command = "cd '" + folder_.path().string() + "' && " + environment +
                                    " '" + program + "' " + arguments + " >out.txt 2>err.txt";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(path("out.txt")),
                read_file(path("err.txt"))};
    }

    test::Folder folder_;
};

} // namespace scree::tests
