/* A plugin in plain C, and with HASP_FAULT one that is wrong in one way each. */
#include "HapticDevicePlugin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* settings: a letter, what is wrong from the second exchange on; "" nothing. */
typedef struct Session
{
  char how;
  int calls;
} Session;

static int Describe(const char* settings, HaspHapticProfile* p)
{
  if (p->size != sizeof *p)
    abort();
  if (settings[0] == '?')
    return settings[1] == '?' ? 7 : HASP_HAPTIC_NOT_UNDERSTOOD;
  p->poseAxes = 6;
  p->forceAxes = 6;
  p->buttons = 2;
  p->workspaceMm[0] = p->workspaceMm[1] = p->workspaceMm[2] = 100.0;
  p->peakForceN = 5.0;
  p->continuousForceN = 1.0;
  p->peakTorqueNmm = 50.0;
  p->movingMassKg = 0.1;
  switch (settings[0])
  {
    case 'P':
      p->poseAxes = 4;
      break;
    case 'F':
      p->peakForceN = NAN;
      break;
    case 'M':
      p->movingMassKg = 0.0;
      break;
    case 'B':
      p->buttons = 33;
      break;
    case '3':
      p->poseAxes = 3;
      break;
    case '0': /* input alone, with the most buttons */
      p->forceAxes = 0;
      p->peakForceN = p->continuousForceN = p->peakTorqueNmm = 0.0;
      p->buttons = 32;
      break;
    default:
      break;
  }
  return HASP_HAPTIC_DESCRIBED;
}

static void* Open(const char* settings, int* trouble)
{
  Session* session;
  if (*trouble != HASP_HAPTIC_ABSENT)
    abort();
  if (strcmp(settings, "busy") == 0)
    *trouble = HASP_HAPTIC_BUSY;
  if (strcmp(settings, "forbidden") == 0)
    *trouble = HASP_HAPTIC_FORBIDDEN;
  if (strcmp(settings, "odd") == 0)
    *trouble = 12345;
  if (strlen(settings) > 2)
    return NULL;
  session = calloc(1, sizeof *session);
  session->how = settings[0];
  return session;
}

static int Exchange(void* opened, const HaspHapticWrench* wrench, HaspHapticSample* sample)
{
  Session* session = opened;
  if (sample->size != sizeof *sample || sample->positionMm[0] != 0.0)
    abort();
  /* The wrench comes back as a position, so that a test can see it. */
  memcpy(sample->positionMm, wrench->forceN, sizeof wrench->forceN);
  sample->orientation[0] = 1.0;
  sample->buttons = 2u;
  switch (++session->calls > 1 ? session->how : ' ')
  {
    case 'n':
      return HASP_HAPTIC_NONE;
    case 'l':
      return HASP_HAPTIC_LOST;
    case '7':
      return 7;
    case 'N':
      sample->positionMm[1] = NAN;
      break;
    case 'I':
      sample->orientation[3] = INFINITY;
      break;
    case 'f':
      sample->positionMm[1] = 1e9;
      break;
    case 'q':
      sample->orientation[0] = 2.0;
      break;
    case 'z':
      sample->orientation[0] = 0.0;
      break;
    case 'b':
      sample->buttons = 4u;
      break;
    case 'h':
      sample->notHomed = 1u;
      break;
    case 's': /* wrong now and then, which is no end */
      sample->orientation[0] = session->calls % 50 == 0 ? 1.0 : 2.0;
      break;
    case '0':
      sample->buttons = 0x80000000u;
      break;
    case '3': /* leaves the turn out, which nobody reads */
      sample->orientation[0] = 0.0;
      break;
    case 't':
      memcpy(sample->positionMm, wrench->torqueNmm, sizeof wrench->torqueNmm);
      break;
    default:
      break;
  }
  return HASP_HAPTIC_GIVEN;
}

static void Close(void* session)
{
  free(session); /* twice, or of another: the sanitizers and the allocator see it */
}

static const char* Advice(void* opened)
{
  static char text[400];
  Session* session = opened;
  if (session->how != 'a')
    return NULL;
  memset(text, 'x', sizeof text); /* endless, and not all to be printed */
  memcpy(text, "Move\x1b[31m it", 12);
  return text;
}

#if HASP_FAULT == 1
#define VERSION 2u
#else
#define VERSION HASP_HAPTIC_DEVICE_PLUGIN_VERSION
#endif
#if HASP_FAULT == 2
#define SIZE 16
#else
#define SIZE sizeof(HaspHapticDevicePlugin)
#endif
#if HASP_FAULT == 3
#define EXCHANGE NULL
#else
#define EXCHANGE Exchange
#endif
#if HASP_FAULT == 7
#define ADVICE NULL
#else
#define ADVICE Advice
#endif
#if HASP_FAULT == 8
#define NAME NULL
#else
#define NAME "te\x1b[31mst\xc3\xa4"
#endif

#if HASP_FAULT == 4
const HaspHapticDevicePlugin* HaspGetHapticDevicePlugin(void)
{
  return NULL;
}
#elif HASP_FAULT == 5
int SomethingElse = 0;
#else
static const HaspHapticDevicePlugin table = { SIZE, VERSION, NAME, Describe, Open, EXCHANGE, Close,
  ADVICE };
const HaspHapticDevicePlugin* HaspGetHapticDevicePlugin(void)
{
  return &table;
}
#endif
#if HASP_FAULT == 6
extern int NobodyHasThis(void);
int CallIt(void)
{
  return NobodyHasThis();
}
#endif
