#include "ContactRivals.h"

namespace rival::o2
{
#include "ContactRival-inl.h"
}
