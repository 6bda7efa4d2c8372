/* Renders and exports saved scenes: what libgluray-engine.so has for `gluray render` and `gluray export`.
   Called by one thread at a time of a process that draws nothing itself. */
#pragma once
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { kGlurayRenderVersion = 2 };

/* What rows of pictures have. */
enum {
  kGlurayBytes = 0,     /* RGBA8, red in the lowest byte: premultiplied displayed values */
  kGlurayDisplayed = 1, /* four floats: the same, neither rounded nor limited to 0 .. 1 */
  kGlurayLinear = 2     /* floats, the channels of an OpenEXR file */
};

/* A camera in the program's world space. */
typedef struct GlurayCamera {
  double position[3], focalPoint[3], up[3];
  double viewAngle;     /* of the whole height, degrees; 0: a parallel projection */
  double parallelScale; /* half the height of the view, of parallel projections */
} GlurayCamera;

typedef struct GlurayRenderRequest {
  int version;                 /* kGlurayRenderVersion */
  const char* scene;           /* file */
  int width, height;           /* pixels; 0: those of the window */
  const char* fit;             /* "all", "crop", "stretch" */
  int transparent;             /* the background */
  int overlays;                /* text, axes and widgets that the program drew */
  int firstPicture;            /* pictures before it are not made */
  int firstBand;               /* nor bands of that picture before it */
  int values;                  /* kGlurayBytes ... */
  const char* layers;          /* of kGlurayLinear: names and commas; "all"; "": colours alone */
  int pictures;                /* the camera goes around the scene once in so many; 1: the saved view */
  const char* const* settings; /* "name=value": in place of those of the scene */
  int settingCount;
  const GlurayCamera* cameras; /* one for each picture, in place of the turn; null: none */
  /* Among them is that of the saved view. */
  const GlurayCamera* savedCameras;
  int savedCameraCount;
  int savedCameraStated; /* there is one, and somebody says that it is that of the saved view */
  const char* sceneHash; /* the picture is made of the scene with this hash alone; null: of any */
} GlurayRenderRequest;

/* Receives pictures, in bands of rows from the top on. */
typedef struct GlurayRenderSink {
  void* user;
  /* A picture's number from 0, its size, rows of a band, and facts about the scene: JSON, with its "hash". 0:
   * ends the work.
   */
  int (*begin)(void* user, int picture, int width, int height, int bandRows, const char* facts);
  /* What OpenEXR files of the pictures have, for glurayWriteExr(), and how many values a pixel has: called
   * before the first begin(), if `values` is kGlurayLinear. JSON. 0: ends the work. */
  int (*channels)(void* user, int count, const char* header);
  /* Pixels as the request's `values` says, top row first. 0: ends the work. */
  int (*rows)(void* user, int band, int count, const void* pixels);
  /* The picture is whole. 0: ends the work. */
  int (*end)(void* user);
  /* One line about something that is not as in the program. */
  void (*note)(void* user, const char* line);
} GlurayRenderSink;

/* 1: all pictures are whole; 0: one line in `why`, empty if the sink has ended the work. */
int glurayRender(const GlurayRenderRequest* request, const GlurayRenderSink* sink, char* why,
                 unsigned long whyBytes);

/* An OpenEXR file of rows that glurayRender() has given. */
typedef struct GlurayExrRequest {
  int version; /* kGlurayRenderVersion */
  const char* file;
  int width, height;
  int half;           /* colours have 16 bits a channel, not 32 */
  const char* header; /* from GlurayRenderSink::channels */
  const char* texts;  /* attributes of the header: a JSON object of texts */
  void* user;
  /* Gives a row from the top: values of all channels, pixel by pixel. 0: ends the work. */
  int (*row)(void* user, int y, float* values);
} GlurayExrRequest;

/* 1: written; 0: one line in `why`, empty if `row` has ended the work; a file of that name stays as it was.
 */
int glurayWriteExr(const GlurayExrRequest* request, char* why, unsigned long whyBytes);

/* Writes a saved scene in another program's form, which the ending of the file's name says: .glb, .obj, .ply.
 */
typedef struct GlurayExportRequest {
  int version;       /* kGlurayRenderVersion */
  const char* scene; /* files */
  const char* file;
  void* user;
  /* Makes a PNG file of `channels` bytes a pixel, 3 or 4, and calls take(into, bytes, size) with it. 0:
   * failed. */
  int (*png)(void* user, int width, int height, int channels, const uint8_t* pixels,
             void (*take)(void* into, const void* bytes, unsigned long size), void* into);
  /* One line about something that was left out or approximated. */
  void (*note)(void* user, const char* line);
} GlurayExportRequest;

/* 1: written; 0: one line in `why`, and files of these names stay as they were. */
int glurayExport(const GlurayExportRequest* request, char* why, unsigned long whyBytes);

#ifdef __cplusplus
}
#endif
