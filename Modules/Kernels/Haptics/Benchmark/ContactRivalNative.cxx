#include "Benchmark/ContactRivals.h"

namespace rival::native
{
#include "Benchmark/ContactRival-inl.h"
}
