#include "HaspProcess.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

extern char** environ;

namespace fs = std::filesystem;

namespace
{

constexpr const char* Canary = "Mustermann_Erika_1964";

/// This process's, on another display or none. The text must outlive it.
std::vector<char*> Environment(std::string& display)
{
  std::vector<char*> kept;
  for (char** entry = environ; *entry; ++entry)
    if (std::string(*entry).rfind("DISPLAY=", 0) != 0)
      kept.push_back(*entry);
  if (!display.empty())
    kept.push_back(display.data());
  kept.push_back(nullptr);
  return kept;
}

pid_t Spawn(const std::vector<std::string>& arguments, const posix_spawn_file_actions_t& actions,
  const std::string& display)
{
  std::vector<std::string> words{ HASP_PROGRAM };
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  std::string entry = display.empty() ? "" : "DISPLAY=" + display;
  if (posix_spawn(
        &child, HASP_PROGRAM, &actions, nullptr, pointers.data(), Environment(entry).data()) != 0)
    throw std::runtime_error("cannot run " HASP_PROGRAM);
  return child;
}

std::string TakeFile(const fs::path& path)
{
  const std::string text = ReadBytes(path.string());
  fs::remove(path);
  return text;
}

} // namespace

std::string ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

std::string OutputOfHasp(const std::vector<std::string>& arguments)
{
  const HaspRun run = RunHasp(arguments);
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return run.out;
}

pid_t StartHasp(
  const std::vector<std::string>& arguments, int errorPipe, const std::string& display)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, errorPipe, STDERR_FILENO);
  const pid_t child = Spawn(arguments, actions, display);
  posix_spawn_file_actions_destroy(&actions);
  return child;
}

HaspRun RunHasp(
  const std::vector<std::string>& arguments, const std::string& device, const std::string& display)
{
  const fs::path base = fs::temp_directory_path() / ("hasp-run-" + std::to_string(getpid()));
  const std::string out = base.string() + ".out", err = base.string() + ".err";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(
    &actions, STDOUT_FILENO, device.empty() ? out.c_str() : device.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), flags, 0600);
  const pid_t child = Spawn(arguments, actions, display);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return { code, TakeFile(out), TakeFile(err) };
}

HaspTest::HaspTest()
  : folder(fs::temp_directory_path() / (std::string(Canary) + "-" + std::to_string(getpid())))
{
  fs::create_directories(this->folder);
}

HaspTest::~HaspTest()
{
  std::error_code ignored; // a folder that stays is no reason to fail the test
  fs::remove_all(this->folder, ignored);
}

void HaspTest::WriteText(const std::string& name, const std::string& text) const
{
  std::ofstream(this->folder / name) << text;
}

std::string HaspTest::Phantom(const std::string& name) const
{
  const HaspRun run =
    RunHasp({ "phantom", "--spacing", "6,6,7", "--quiet", "--output", this->Path(name) });
  EXPECT_EQ(run.exitCode, 0) << run.err;
  return this->Path(name);
}

std::vector<std::string> HaspTest::Names() const
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(this->folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void ExpectFailure(const HaspRun& run, int exitCode, const std::string& words)
{
  EXPECT_EQ(run.exitCode, exitCode) << run.err;
  EXPECT_NE(run.err.find(words), std::string::npos) << "'" << words << "' is not in: " << run.err;
  EXPECT_EQ((run.err + run.out).find(Canary), std::string::npos) << run.err << run.out;
}
