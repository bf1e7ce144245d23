#pragma once
#include <pthread.h>
#include <signal.h>

namespace hasp
{

/// While this is there the thread that made it, and each thread that it starts, takes no signals:
/// they go to the threads of the program, not to ours. Any thread.
class SignalsBlocked
{
public:
  SignalsBlocked() noexcept
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &this->Before);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &this->Before, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

private:
  sigset_t Before;
};

} // namespace hasp
