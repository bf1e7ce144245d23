/* A plugin in plain C, and with HASP_FAULT one that is wrong in one way each. */
#include "Devices/HeadPosePlugin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* settings: a digit, what Poll answers from the second call on; "" the good pose. */
typedef struct Session
{
  char how;
  int calls;
} Session;

static void* Open(const char* settings)
{
  Session* session;
  if (strcmp(settings, "absent") == 0)
    return NULL;
  session = calloc(1, sizeof *session);
  session->how = settings[0];
  return session;
}

static int Poll(void* opened, double nowS, HaspHeadPoseSample* sample)
{
  Session* session = opened;
  if (sample->size != sizeof *sample)
    abort();
  sample->ageS = 0.01;
  sample->positionMm[0] = 100.0 * sin(nowS);
  sample->positionMm[2] = 500.0;
  sample->orientation[0] = 1.0;
  if (++session->calls > 1)
    switch (session->how)
    {
      case 'n':
        return HASP_HEAD_POSE_NONE;
      case 'l':
        return HASP_HEAD_POSE_LOST;
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
      case 'a':
        sample->ageS = -1.0;
        break;
      case 'A':
        sample->ageS = NAN;
        break;
      default:
        break;
    }
  return HASP_HEAD_POSE_GIVEN;
}

static void Close(void* session)
{
  free(session);
}

#if HASP_FAULT == 1
#define VERSION 2u
#else
#define VERSION HASP_HEAD_POSE_PLUGIN_VERSION
#endif
#if HASP_FAULT == 2
#define SIZE 16
#else
#define SIZE sizeof(HaspHeadPosePlugin)
#endif
#if HASP_FAULT == 3
#define POLL NULL
#else
#define POLL Poll
#endif

#if HASP_FAULT == 4
const HaspHeadPosePlugin* HaspGetHeadPosePlugin(void)
{
  return NULL;
}
#elif HASP_FAULT == 5
int SomethingElse = 0;
#else
static const HaspHeadPosePlugin table = { SIZE, VERSION, "te\x1b[31mst\xc3\xa4", Open, POLL,
  Close };
const HaspHeadPosePlugin* HaspGetHeadPosePlugin(void)
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
