/* Exports of plugin.c. */
#pragma once
#define EXPORT __attribute__((visibility("default")))

/* Draws all frames into the context that is current; 1 if the image is right. */
EXPORT int pluginDraw(void (*show)(void*), void* user);

EXPORT int Java_Door_draw(void* environment, void* class);
