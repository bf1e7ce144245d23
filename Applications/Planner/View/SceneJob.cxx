#include "View/SceneJob.h"

#include "Model/JobQueue.h"

namespace hasp
{

void SceneJob::Begin(const QString& what, Work work)
{
  this->Drop();
  const auto ticket = std::make_shared<Ticket>();
  this->Running = ticket;
  this->Jobs.Add(what,
    [this, ticket, work = std::move(work)](const ProgressFunction& progress) -> JobQueue::Finish
    {
      Take take;
      try
      {
        if (!ticket->dropped)
          take =
            work([&](double share) { return !ticket->dropped && (!progress || progress(share)); });
      }
      catch (const Cancelled&)
      {
        if (!ticket->dropped)
          throw;
      }
      return [this, ticket, take]
      {
        if (ticket->dropped) // and this may be gone
          return;
        this->Running.reset();
        take();
      };
    });
}

void SceneJob::Drop()
{
  if (const auto ticket = this->Running.lock())
    ticket->dropped = true;
  this->Running.reset();
}

} // namespace hasp
