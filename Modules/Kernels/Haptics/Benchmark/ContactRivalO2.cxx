#include "Benchmark/ContactRivals.h"

namespace rival::o2
{
#include "Benchmark/ContactRival-inl.h"
}
