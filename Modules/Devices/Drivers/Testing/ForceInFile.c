/* A device whose motors are a number in a file, which outlives every process: the settings name it.
   What was written last is what the motors do. */
#include "Devices/Drivers/Plugin/HapticDevicePlugin.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void Pull(const char* file, double newton)
{
  FILE* stream = fopen(file, "w");
  if (!stream)
    return;
  fprintf(stream, "%.3f\n", newton);
  fclose(stream);
}

static int Describe(const char* settings, HaspHapticProfile* p)
{
  int a;
  if (settings[0] == '\0')
    return HASP_HAPTIC_NOT_UNDERSTOOD;
  p->poseAxes = 3;
  p->forceAxes = 3;
  p->buttons = 1;
  for (a = 0; a < 3; ++a)
    p->workspaceMm[a] = 40.0;
  p->peakForceN = 5.0;
  p->continuousForceN = 5.0;
  p->movingMassKg = 0.1;
  return HASP_HAPTIC_DESCRIBED;
}

static void* Open(const char* settings, int* trouble)
{
  (void)trouble;
  Pull(settings, 0.0);
  return strdup(settings);
}

static int Exchange(void* session, const HaspHapticWrench* wrench, HaspHapticSample* sample)
{
  Pull((const char*)session, wrench->forceN[2]);
  sample->orientation[0] = 1.0;
  return HASP_HAPTIC_GIVEN;
}

static void Close(void* session)
{
  Pull((const char*)session, 0.0);
  free(session);
}

static const HaspHapticDevicePlugin table = { sizeof table, HASP_HAPTIC_DEVICE_PLUGIN_VERSION,
  "force in a file", Describe, Open, Exchange, Close, 0 };

const HaspHapticDevicePlugin* HaspGetHapticDevicePlugin(void)
{
  return &table;
}
