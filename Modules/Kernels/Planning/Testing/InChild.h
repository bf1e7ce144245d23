#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <exception>
#include <functional>

/// Runs `act` in a child process and returns its exit status; 1 if it throws.
inline int InChild(const std::function<void()>& act)
{
  const pid_t child = fork();
  if (child == 0)
  {
    int status = 0;
    try
    {
      act();
    }
    catch (const std::exception&)
    {
      status = 1;
    }
    _exit(status);
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
