/* Shows saved scenes: what libgluray-engine.so has for `gluray view`. Each view is used by one thread at a
   time of a process that draws nothing itself. */
#pragma once
#include "saved/program/render.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct GlurayView GlurayView;

/* What is known of a scene. Pointers are valid until glurayViewClose(). */
typedef struct GlurayViewFacts {
  int width, height;     /* of the window; pixels */
  const uint32_t* shown; /* the window's pixels, RGBA8, bottom row first; null: not known */
  int movable;           /* the camera of the saved view is known: what follows is set */
  GlurayCamera camera;   /* in a world that the scene has */
  double middle[3];      /* of a ball around the surfaces, in that world */
  double radius;
  const char* settings; /* of the largest view, as the program had them: a JSON object of texts */
} GlurayViewFacts;

/* Null: one line in `why`. `version`: kGlurayRenderVersion. */
GlurayView* glurayViewOpen(int version, const char* scene, GlurayViewFacts* facts, char* why,
                           unsigned long whyBytes);
void glurayViewClose(GlurayView* view);

typedef struct GlurayViewRequest {
  int width, height;           /* pixels */
  const GlurayCamera* camera;  /* null: the saved view */
  const char* const* settings; /* "name=value": in place of those of the scene */
  int settingCount;
  int moving; /* one frame of a moving view; otherwise the picture that glurayRender() makes */
} GlurayViewRequest;

typedef struct GlurayViewSink {
  void* user;
  /* Whether somebody wants something else. Called by several threads. Not of moving views. */
  int (*stop)(void* user);
  /* The picture so far: premultiplied RGBA8, top row first. `noise`: infinite: not known yet; 0: none. */
  void (*take)(void* user, int width, int height, const uint32_t* pixels, unsigned passes, double noise,
               int finished);
} GlurayViewSink;

/* 1: the picture is finished, or the frame is whole; 0: stopped, or failed with one line in `why`. */
int glurayViewShow(GlurayView* view, const GlurayViewRequest* request, const GlurayViewSink* sink, char* why,
                   unsigned long whyBytes);

/* The point of the first surface at a pixel of a picture, counted from its upper left corner, in the camera's
   world. 0: there is none. */
int glurayViewPoint(GlurayView* view, const GlurayViewRequest* request, int x, int y, double point[3]);

#ifdef __cplusplus
}
#endif
