#ifndef HaspHapticDevicePlugin_h
#define HaspHapticDevicePlugin_h
/* The boundary for haptic devices whose makers' SDK cannot be part of Hasp: a shared library of
   your own, plain C, loaded when the user names its file. Nothing else of Hasp is needed to build
   it.

     #include "HapticDevicePlugin.h"
     static int Describe(const char* settings, HaspHapticProfile* p) // without touching the device
     {
       if (settings[0] != '\0')
         return HASP_HAPTIC_NOT_UNDERSTOOD; // none are known here
       p->poseAxes = 6;
       p->forceAxes = 3;
       p->buttons = 2;
       p->workspaceMm[0] = 80; // then y, z, and the rest of HaspHapticProfile
       …
       return HASP_HAPTIC_DESCRIBED;
     }
     static void* Open(const char* settings, int* trouble)
     {
       void* device = sdk_connect();
       if (!device && sdk_error() == SDK_IN_USE)
         *trouble = HASP_HAPTIC_BUSY; // else it stays HASP_HAPTIC_ABSENT
       return device;
     }
     static int Exchange(void* session, const HaspHapticWrench* wrench, HaspHapticSample* sample)
     {
       sdk_pose p;
       sdk_set_force(session, wrench->forceN);
       if (sdk_gone(session))
         return HASP_HAPTIC_LOST;
       if (!sdk_wait_for_next(session, &p, 5)) // ms
         return HASP_HAPTIC_NONE;
       for (int a = 0; a < 3; ++a)
         sample->positionMm[a] = 1000.0 * p.metres[a];
       sample->orientation[0] = p.qw; // then x, y, z
       sample->buttons = p.buttons;
       return HASP_HAPTIC_GIVEN;
     }
     static void Close(void* session)
     {
       static const double none[3] = { 0, 0, 0 };
       sdk_set_force(session, none);
       sdk_disconnect(session);
     }
     static const HaspHapticDevicePlugin table = { sizeof table, HASP_HAPTIC_DEVICE_PLUGIN_VERSION,
       "my device", Describe, Open, Exchange, Close, 0 };
     const HaspHapticDevicePlugin* HaspGetHapticDevicePlugin(void) { return &table; }

     cc -shared -fPIC -fvisibility=default my.c -o my.so -lsdk

   A whole one that runs without a device: Sample/SpringBox.c.

   Frames: device axes, right-handed: mm, origin in the middle of the workspace, x to the user's
   right, y up, z towards the user. The body is the stylus, grip or handle. Forces are felt by the
   hand, along the same axes, N; a torque is about the body's origin, in device axes, N mm.
   Zero force on close is yours: when Close returns the motors pull no more, whatever came last.
   Hasp says zero before it closes where it can, and cannot where an exchange did not return.
   What Hasp says is safe to pass on: finite, within your profile, ramped and watched over. What you
   say is checked: a sample that cannot be is dropped, and many in a row end the session.
   Threads: Describe comes before all else. Open, Exchange, Advice and Close come from one thread at
   a time, which is no thread of yours; about 1000 exchanges a second. An exchange may wait for the
   device, 20 ms at most; do not sleep where the SDK has newer data. Throw no C++ exceptions.
   Your code runs inside Hasp: it may do all that the user may. A crash of yours ends Hasp. After
   that, and after any other sudden end, another process (hasp-device-guard) opens and closes your
   device, so that it is left without force: open must work right then.

   How SDKs fit (from what is public about them; none was at hand here):

   OpenHaptics, HD API (Touch, Phantom). It runs a servo loop of its own at 1 kHz, in which alone a
   frame may be begun and ended. Open initialises the device, schedules an asynchronous callback and
   starts the scheduler; Close schedules a last frame of zero force, waits for it, and only then
   unschedules, stops and disables. The callback copies position, the 4 by 4 transform and buttons
   out and the newest force in, through one small lock-free cell; Exchange waits up to 2 ms for the
   callback's next turn. Its positions are in mm and its axes are ours; its origin is the arm's, so
   take off the middle of the usable workspace. The transform is column-major: make the quaternion
   from its rotation, and normalise. Its force is in N; limit it by what the SDK says is the nominal
   maximum. An error of the force, temperature or communication kind is NONE once and LOST when it
   stays. Uncalibrated encoders are notHomed, and Advice says where to put the stylus.

   Force Dimension, dhd (omega, delta, sigma, lambda; also Falcon). No loop of its own: Exchange
   sets force (and torque where the wrist has motors) and gets position and rotation frame, in calls
   that wait for USB. Metres and N m: times 1000. Its x points to the user, y to the
   user's right, z up: ours are (y, z, x). Tell the SDK to leave gravity compensation on, and switch
   forces on in Open and off in Close. A negative return with "no such device" or a timeout kind is
   LOST. Models differ in axes: ask for the model in the settings, so that Describe can answer
   without it.

   A tracker without motors (optical, magnetic, a controller of a headset). forceAxes is 0 and the
   peak forces are 0: Exchange ignores the wrench. It gives GIVEN when a new pose came and NONE when
   not, also when the body is hidden; LOST only when the tracker itself is gone. Subtract a middle
   of the workspace that the user chose in the settings, and turn its axes into ours. */
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

#define HASP_HAPTIC_DEVICE_PLUGIN_VERSION 1u
#define HASP_HAPTIC_DEVICE_PLUGIN_ENTRY "HaspGetHapticDevicePlugin"

  enum
  {
    /* describe */
    HASP_HAPTIC_NOT_UNDERSTOOD = 0, /* the settings */
    HASP_HAPTIC_DESCRIBED = 1,
    /* exchange */
    HASP_HAPTIC_NONE = 0,  /* nothing new; the pose before stays */
    HASP_HAPTIC_GIVEN = 1, /* a new sample */
    HASP_HAPTIC_LOST = -1, /* the device is gone; close comes next, and perhaps open */
    /* open, where it gives no session */
    HASP_HAPTIC_ABSENT = 0,
    HASP_HAPTIC_BUSY = 1,     /* another program has it */
    HASP_HAPTIC_FORBIDDEN = 2 /* the system does not let this user */
  };

  /* What the device can do; all zero but size when it comes. Write no further than size. */
  typedef struct HaspHapticProfile
  {
    uint32_t size;              /* set by Hasp: sizeof, as Hasp was compiled */
    int32_t poseAxes;           /* 3 (position) or 6 */
    int32_t forceAxes;          /* 0 (input alone), 3 or 6 */
    int32_t buttons;            /* [0, 32] */
    int32_t delayTicks;         /* from a wrench to the pose it moved, at 1 kHz: [0, 16] */
    int32_t reserved;           /* 0 */
    double workspaceMm[3];      /* half of its box along x, y, z: [0.001, 10000] */
    double peakForceN;          /* [0, 1000] */
    double continuousForceN;    /* for minutes: [0, peakForceN] */
    double peakTorqueNmm;       /* [0, 1e6]; 0 unless forceAxes is 6 */
    double continuousTorqueNmm; /* [0, peakTorqueNmm] */
    double stiffnessNPerMm;     /* the largest that its maker names: [0, 1e4] */
    double dampingNsPerMm;      /* its own, felt in free space: [0, 1] */
    double movingMassKg;        /* felt in free space: [1e-6, 100] */
    double positionQuantumMm;   /* an encoder's count: [0, 10] */
    double angleQuantumRad;     /* [0, 1] */
  } HaspHapticProfile;

  typedef struct HaspHapticWrench
  {
    double forceN[3];    /* what the hand is to feel: at most peakForceN long */
    double torqueNmm[3]; /* 0 unless forceAxes is 6 */
  } HaspHapticWrench;

  /* What the device said; all zero but size when it comes. Write no further than size. */
  typedef struct HaspHapticSample
  {
    uint32_t size;         /* set by Hasp: sizeof, as Hasp was compiled */
    uint32_t buttons;      /* bit n: button n is held; none above the profile's */
    uint32_t notHomed;     /* not 0: where it is, is not known yet. No force comes then */
    uint32_t reserved;     /* 0 */
    double positionMm[3];  /* within 10 m of 0 */
    double orientation[4]; /* quaternion w, x, y, z; unit within 0.001. Body to device axes. Ignored
                              where poseAxes is 3 */
  } HaspHapticSample;

  typedef struct HaspHapticDevicePlugin
  {
    uint32_t size;    /* sizeof(HaspHapticDevicePlugin), as you compiled it; larger is fine */
    uint32_t version; /* HASP_HAPTIC_DEVICE_PLUGIN_VERSION */
    const char* name; /* of the device, ASCII; the first 63 characters count */
    /* settings: what the user wrote behind the file's name and a colon (my.so:SETTINGS), "" if
     * nothing. May come any number of times, with no device there; the same answer each time. */
    int (*describe)(const char* settings, HaspHapticProfile* profile);
    /* NULL: it cannot be opened; *trouble then says why, and is HASP_HAPTIC_ABSENT when it comes.
     * The session begins without force. */
    void* (*open)(const char* settings, int* trouble);
    /* The wrench holds until the next one. */
    int (*exchange)(void* session, const HaspHapticWrench* wrench, HaspHapticSample* sample);
    /* Once for each session that open gave, within 100 ms: zero force, then let it go. */
    void (*close)(void* session);
    /* What the user has to do now, a sentence in ASCII of at most 200 characters that stays until
     * the next call; NULL where there is nothing. The pointer itself may be NULL. */
    const char* (*advice)(void* session);
  } HaspHapticDevicePlugin;

  /* The one symbol that is looked for. */
  typedef const HaspHapticDevicePlugin* (*HaspGetHapticDevicePluginFunction)(void);
#if defined(__GNUC__)
  __attribute__((visibility("default")))
#endif
  const HaspHapticDevicePlugin*
  HaspGetHapticDevicePlugin(void);

#ifdef __cplusplus
}
#endif
#endif
