// Runs the real decoder in the same place, with the same words and pipes, and appends "MODE KIB" to
// the file HASP_PEAK_FILE names: the most memory it held at once. A program of its own, because a
// process starts with the peak of the one it was made from, and a test's is far larger.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

int main(int, char** argv)
{
  const pid_t child = fork();
  if (child == 0)
  {
    execv(HASP_REAL_DECODER, argv);
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) != child)
    return 126;
  if (std::FILE* file = std::fopen(std::getenv("HASP_PEAK_FILE"), "a"))
  {
    std::fprintf(file, "%s %ld\n", argv[1], used.ru_maxrss);
    std::fclose(file);
  }
  if (WIFSIGNALED(status))
    kill(getpid(), WTERMSIG(status));
  return WEXITSTATUS(status);
}
