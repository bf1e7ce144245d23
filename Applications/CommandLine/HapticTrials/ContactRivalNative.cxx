#include "ContactRivals.h"

namespace rival::native
{
#include "ContactRival-inl.h"
}
