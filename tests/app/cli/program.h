// Runs the program as people do, and gives back what it printed.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

namespace texelscope {

struct Ran {
    int code = -1;
    std::string out, err;
};

/// @param arguments  as a shell takes them.
inline Ran run_program(const std::string& arguments, const std::string& input = "") {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("texelscope_program_" + std::to_string(getpid()));
    fs::create_directories(folder);
    std::ofstream(folder / "in") << input;
    const std::string command = std::string("'") + TEXELSCOPE_BINARY + "' " + arguments + " <'" +
                                (folder / "in").string() + "' >'" + (folder / "out").string() + "' 2>'" +
                                (folder / "err").string() + "'";
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): the shell is what is tested
    const auto text = [&](const char* name) {
        std::ifstream file(folder / name, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    Ran ran{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text("out"), text("err")};
    fs::remove_all(folder);
    return ran;
}

}  // namespace texelscope
