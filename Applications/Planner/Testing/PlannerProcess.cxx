#include "PlannerProcess.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace fs = std::filesystem;

namespace
{

using Clock = std::chrono::steady_clock;
constexpr auto LookAgain = std::chrono::milliseconds(3);

std::string ReadAll(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

/// This process's, but for what says where a user's own things are.
std::vector<std::string> EnvironmentOf(const PlannerStart& start)
{
  std::vector<std::string> kept;
  for (char** entry = environ; *entry; ++entry)
  {
    const std::string text(*entry);
    const bool replaced = text.starts_with("DISPLAY=") || text.starts_with("HOME=") ||
                          text.starts_with("XDG_") || text.starts_with("QT_QPA_PLATFORM=") ||
                          text.starts_with("LC_ALL=") || text.starts_with("WAYLAND_DISPLAY=");
    if (!replaced)
      kept.push_back(text);
  }
  const std::string home = start.home.string();
  for (const std::string& entry : { "DISPLAY=" + start.display, "HOME=" + home,
         "XDG_STATE_HOME=" + home + "/state", "XDG_CONFIG_HOME=" + home + "/config",
         "XDG_CACHE_HOME=" + home + "/cache", "XDG_RUNTIME_DIR=" + home + "/run",
         std::string("QT_QPA_PLATFORM=xcb"), std::string("LC_ALL=C.UTF-8") })
    kept.push_back(entry);
  return kept;
}

std::vector<char*> Pointers(std::vector<std::string>& words)
{
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

} // namespace

PlannerProcess::PlannerProcess(const PlannerStart& start)
  : patienceS(start.patienceS),
    User(start.display),
    File(start.home / "layout.json"),
    Written(start.home / "output.txt")
{
  fs::create_directories(start.home / "run");
  fs::permissions(start.home / "run", fs::perms::owner_all); // Qt asks for it
  fs::remove(this->File);
  this->Start(start);
  try
  {
    this->Await(
      "the first layout", [](const Json& now) { return now.is_object(); }, false);
    while (!this->User.SeesWindow())
      std::this_thread::sleep_for(LookAgain);
    this->User.FillScreen();
    this->WaitSettled();
  }
  catch (...)
  {
    this->Kill9();
    throw;
  }
}

PlannerProcess::~PlannerProcess()
{
  if (this->IsRunning())
    this->Kill9();
}

void PlannerProcess::Start(const PlannerStart& start)
{
  const std::string program = HASP_PLANNER_PROGRAM;
  std::vector<std::string> words{ program, "--layout", this->File.string() };
  words.insert(words.end(), start.words.begin(), start.words.end());
  std::vector<std::string> variables = EnvironmentOf(start);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(
    &actions, STDOUT_FILENO, this->Written.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  const int failed = posix_spawn(&this->Child, program.c_str(), &actions, nullptr,
    Pointers(words).data(), Pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed)
    throw std::runtime_error("cannot run " + program);
}

bool PlannerProcess::ReadLayout()
{
  std::error_code error;
  const auto changed = fs::last_write_time(this->File, error);
  if (error || changed == this->ReadAt)
    return false;
  Json read = Json::parse(ReadAll(this->File), nullptr, false);
  if (read.is_discarded())
    return false;
  this->Now = std::move(read);
  this->ReadAt = changed;
  return true;
}

bool PlannerProcess::Comes(
  double withinS, const std::function<bool(const Json&)>& holds, bool counted)
{
  const auto start = Clock::now();
  for (auto before = start; this->IsRunning();)
  {
    this->ReadLayout();
    const auto now = Clock::now();
    const double passedS = std::chrono::duration<double>(now - before).count();
    before = now;
    if (counted)
    {
      this->WaitS += passedS;
      if (this->Now.is_object() && this->Now["state"].value("busy", false))
        this->BusyS += passedS;
    }
    if (holds(this->Now))
      return true;
    if (std::chrono::duration<double>(now - start).count() > withinS)
      return false;
    std::this_thread::sleep_for(LookAgain);
  }
  return false;
}

void PlannerProcess::Await(
  const std::string& what, const std::function<bool(const Json&)>& holds, bool counted)
{
  if (this->Comes(this->patienceS, holds, counted))
    return;
  const bool running = this->IsRunning();
  this->Fail((running ? "this did not come: "
                      : "it ended with " + std::to_string(this->Code) + " before this came: ") +
             what);
}

void PlannerProcess::WaitUntil(
  const std::string& what, const std::function<bool(const Json&)>& holds)
{
  this->Await(what, holds, true);
}

void PlannerProcess::WaitSettled()
{
  this->WaitUntil("rest", [](const Json& now) { return now["state"].value("settled", false); });
}

/// Until the program has counted all that is sent here. It may count more: a click beside a menu
/// comes again.
void PlannerProcess::Act(const std::function<void()>& input)
{
  this->WaitSettled();
  const auto base = this->Now["state"].value("events", 0ULL);
  const auto sent = this->User.Events();
  input();
  const auto wanted = base + this->User.Events() - sent;
  this->WaitUntil(std::to_string(wanted) + " events",
    [&](const Json& now) {
      return now["state"].value("events", 0ULL) >= wanted && now["state"].value("settled", false);
    });
}

void PlannerProcess::Fail(const std::string& what) const
{
  std::string text = "the planner: " + what + "\n--- its layout:\n";
  for (const auto& [key, value] : this->Now.items())
    if (key != "widgets")
      text += key + ": " + value.dump() + "\n";
    else
      for (const Json& widget : value)
        text += widget.dump() + "\n";
  throw std::runtime_error(text + "--- its output:\n" + this->Output());
}

UserEffort PlannerProcess::Effort() const
{
  return { this->User.Clicks(), this->User.Keys(), this->WaitS, this->BusyS };
}

void PlannerProcess::SavePicture(const fs::path& png) const
{
  if (!this->User.Picture().save(QString::fromStdString(png.string()), "PNG"))
    throw std::runtime_error("the picture of the screen cannot be written");
}

void PlannerProcess::CloseWindow()
{
  this->User.CloseWindow();
}

void PlannerProcess::Kill9()
{
  if (this->Child > 0)
    kill(this->Child, SIGKILL);
  this->ExitCode();
}

bool PlannerProcess::IsRunning()
{
  int status = 0;
  if (this->Child > 0 && waitpid(this->Child, &status, WNOHANG) == this->Child)
  {
    this->Child = 0;
    this->Code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return this->Child > 0;
}

int PlannerProcess::ExitCode()
{
  const auto start = Clock::now();
  while (this->IsRunning())
  {
    if (std::chrono::duration<double>(Clock::now() - start).count() > this->patienceS)
      this->Fail("it does not end");
    this->ReadLayout();
    std::this_thread::sleep_for(LookAgain);
  }
  return this->Code;
}

std::string PlannerProcess::Output() const
{
  return ReadAll(this->Written);
}
