/* A haptic device that is not there: a mass on a spring in a box, as a plugin of Hasp. It shows how
   one is written, and lets Hasp's haptics be tried without hardware. README.md says how to build
   it.

   The mass hangs in the middle, pulled back by its spring and slowed by oil; the wrench it gets
   pushes it. Pushed with F it comes to rest F / Stiffness from the middle: 10 mm for 1 N. Each
   exchange is one millisecond of its time, however long it took.

   There is one box: while a session has it, another finds it busy. Settings: "", "held", which
   holds its button down, or "hand", which presses it after a third of a second. */
#include "HapticDevicePlugin.h"

#include <math.h>
#include <string.h>

static const double Stiffness = 0.1; /* N/mm */
static const double Damping = 0.003; /* N s/mm: a little less than would stop all ringing */
static const double Mass = 0.03;     /* kg */
static const double Reach = 40.0;    /* mm: the box's walls */
static const double Tick = 0.001;    /* s */
static const double Peak = 3.0;      /* N */

typedef struct Box
{
  int open;
  int heldFrom; /* exchanges; -1: never */
  int exchanges;
  double positionMm[3];
  double speedMmPerS[3];
} Box;

static Box box;

/* What the motors pull with. They outlive a session as real ones do: who closes without zeroing
   them leaves them pulling. Exported, so that a test can see. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
double SpringBoxMotorsN[3];

static int Describe(const char* settings, HaspHapticProfile* p)
{
  int a;
  if (settings[0] != '\0' && strcmp(settings, "held") != 0 && strcmp(settings, "hand") != 0)
    return HASP_HAPTIC_NOT_UNDERSTOOD;
  p->poseAxes = 3;
  p->forceAxes = 3;
  p->buttons = 1;
  p->delayTicks = 1;
  for (a = 0; a < 3; ++a)
    p->workspaceMm[a] = Reach;
  p->peakForceN = Peak;
  p->continuousForceN = Peak;
  p->stiffnessNPerMm = 1.0;
  p->dampingNsPerMm = Damping;
  p->movingMassKg = Mass;
  return HASP_HAPTIC_DESCRIBED;
}

static void* Open(const char* settings, int* trouble)
{
  if (box.open)
  {
    *trouble = HASP_HAPTIC_BUSY;
    return NULL;
  }
  memset(&box, 0, sizeof box);
  box.open = 1;
  box.heldFrom = strcmp(settings, "held") == 0 ? 0 : strcmp(settings, "hand") == 0 ? 300 : -1;
  return &box;
}

/* Semi-implicit Euler: speed first, then place. Stable, since Tick is far below the mass's period.
 */
static void Move(Box* b)
{
  int a;
  for (a = 0; a < 3; ++a)
  {
    const double forceN =
      SpringBoxMotorsN[a] - Stiffness * b->positionMm[a] - Damping * b->speedMmPerS[a];
    b->speedMmPerS[a] += 1000.0 * forceN / Mass * Tick;
    b->positionMm[a] += b->speedMmPerS[a] * Tick;
    if (fabs(b->positionMm[a]) > Reach)
    {
      b->positionMm[a] = b->positionMm[a] < 0.0 ? -Reach : Reach;
      b->speedMmPerS[a] = 0.0;
    }
  }
}

static int Exchange(void* session, const HaspHapticWrench* wrench, HaspHapticSample* sample)
{
  Box* b = session;
  memcpy(SpringBoxMotorsN, wrench->forceN, sizeof SpringBoxMotorsN);
  Move(b);
  memcpy(sample->positionMm, b->positionMm, sizeof b->positionMm);
  sample->buttons = b->heldFrom >= 0 && b->exchanges >= b->heldFrom ? 1u : 0u;
  if (b->exchanges < b->heldFrom)
    ++b->exchanges;
  return HASP_HAPTIC_GIVEN;
}

static void Close(void* session)
{
  Box* b = session;
  memset(SpringBoxMotorsN, 0, sizeof SpringBoxMotorsN);
  b->open = 0;
}

static const HaspHapticDevicePlugin table = { sizeof table, HASP_HAPTIC_DEVICE_PLUGIN_VERSION,
  "Spring box", Describe, Open, Exchange, Close, NULL };

const HaspHapticDevicePlugin* HaspGetHapticDevicePlugin(void)
{
  return &table;
}
