#ifndef HaspHeadPosePlugin_h
#define HaspHeadPosePlugin_h
/* The boundary for trackers whose makers' SDK cannot be part of Hasp: a shared library of your own,
   plain C, loaded when the user names its file. Nothing else of Hasp is needed to build it.

     #include "HeadPosePlugin.h"
     static void* Open(const char* settings) { return sdk_connect(settings); }   // NULL: not there
     static int Poll(void* session, double nowS, HaspHeadPoseSample* sample)
     {
       sdk_pose p;
       (void)nowS;
       if (!sdk_newest(session, &p))
         return HASP_HEAD_POSE_NONE;
       sample->ageS = p.ms_ago * 0.001;
       for (int a = 0; a < 3; ++a)
         sample->positionMm[a] = 1000.0 * p.metres[a];
       sample->orientation[0] = p.qw; // then x, y, z
       …
       return HASP_HEAD_POSE_GIVEN;
     }
     static void Close(void* session) { sdk_disconnect(session); }
     static const HaspHeadPosePlugin table = { sizeof table, HASP_HEAD_POSE_PLUGIN_VERSION,
       "my tracker", Open, Poll, Close };
     const HaspHeadPosePlugin* HaspGetHeadPosePlugin(void) { return &table; }

     cc -shared -fPIC -fvisibility=default my.c -o my.so -lsdk

   Frames: your tracker's own, right-handed, millimetres; a calibration maps them into the room.
   Threads: Open, Poll and Close come from one thread, RENDER, one at a time. Poll must return at
   once: it is asked once a frame; have a thread of your own if the SDK waits.
   Your code runs inside Hasp: it may do all that the user may. What it says is checked all the
   same. */
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

#define HASP_HEAD_POSE_PLUGIN_VERSION 1u
#define HASP_HEAD_POSE_PLUGIN_ENTRY "HaspGetHeadPosePlugin"

  enum
  {
    HASP_HEAD_POSE_NONE = 0,  /* nothing yet; the view goes on as it was */
    HASP_HEAD_POSE_GIVEN = 1, /* the newest pose, also if it was given before */
    HASP_HEAD_POSE_LOST = -1  /* the tracker is gone: Poll is not called again */
  };

  typedef struct HaspHeadPoseSample
  {
    uint32_t size;        /* set by Hasp: sizeof, as Hasp was compiled; write no further */
    uint32_t reserved;    /* 0 */
    double ageS;          /* how long before nowS the head was there: [0, 10] s */
    double positionMm[3]; /* within 10 m of 0 */
    double
      orientation[4]; /* quaternion w, x, y, z; unit within 0.001. Your marker to your tracker */
  } HaspHeadPoseSample;

  typedef struct HaspHeadPosePlugin
  {
    uint32_t size; /* sizeof(HaspHeadPosePlugin), as you compiled it; larger than Hasp's is fine */
    uint32_t version; /* HASP_HEAD_POSE_PLUGIN_VERSION */
    const char* name; /* of the tracker, ASCII; the first 63 characters count */
    /* settings: what the user wrote behind the file's name and a colon (my.so:SETTINGS), "" if
     * nothing. NULL: it cannot be opened. */
    void* (*open)(const char* settings);
    /* nowS: seconds of a steady clock. Returns HASP_HEAD_POSE_…; sample is zero but for its size.
     */
    int (*poll)(void* session, double nowS, HaspHeadPoseSample* sample);
    /* Once for each session that open gave; the library is unloaded afterwards. */
    void (*close)(void* session);
  } HaspHeadPosePlugin;

  /* The one symbol that is looked for. */
  typedef const HaspHeadPosePlugin* (*HaspGetHeadPosePluginFunction)(void);
#if defined(__GNUC__)
  __attribute__((visibility("default")))
#endif
  const HaspHeadPosePlugin*
  HaspGetHeadPosePlugin(void);

#ifdef __cplusplus
}
#endif
#endif
