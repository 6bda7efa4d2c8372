/* Unusual lifetimes of contexts. Argument: two (contexts in turn), shared (a list of one drawn by the
   other), threads (four contexts in four threads), moved (one context in two threads, one after the other),
   destroyed (while current), midframe (exit between glBegin and glEnd), fork (the child draws too), exec (a
   child process that draws), unmade (the window is destroyed while current). */
#include "linked.h"

#include <pthread.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static Gl gl;
static Glx glx;

static GLXContext contextFor(Client* client, GLXContext share) {
  return glXCreateContext(client->display, client->visual, share, True);
}

static int drawAll(Client* client, GLXContext context) {
  return glXMakeCurrent(client->display, client->window, context) && workload(&gl, showClient, client);
}

static int two(void) {
  Client client = openClient(&glx);
  GLXContext contexts[2] = {contextFor(&client, NULL), contextFor(&client, NULL)};
  const int right = drawAll(&client, contexts[0]) && drawAll(&client, contexts[1]);
  glXMakeCurrent(client.display, None, NULL);
  glXDestroyContext(client.display, contexts[0]);
  glXDestroyContext(client.display, contexts[1]);
  return right;
}

static int shared(void) {
  Client client = openClient(&glx);
  GLXContext first = contextFor(&client, NULL), second = contextFor(&client, first);
  glXMakeCurrent(client.display, client.window, first);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  glVertex3f(-1, -1, 0), glVertex3f(1, -1, 0), glVertex3f(0, 1, 0);
  glEnd();
  glEndList();
  glXMakeCurrent(client.display, client.window, second);
  glXDestroyContext(client.display, first);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glColor3f(1, 0, 0);
  glCallList(list);
  const int right = imageIsRight(&gl);
  return right && drawAll(&client, second);
}

static void* inThread(void* unused) {
  (void)unused;
  Client client = openClient(&glx);
  GLXContext context = contextFor(&client, NULL);
  const int right = drawAll(&client, context);
  glXMakeCurrent(client.display, None, NULL);
  glXDestroyContext(client.display, context);
  return right ? &gl : NULL;
}

static int threads(void) {
  pthread_t started[4];
  int right = 1;
  for (int i = 0; i < 4; ++i) pthread_create(&started[i], NULL, inThread, NULL);
  for (int i = 0; i < 4; ++i) {
    void* result = NULL;
    pthread_join(started[i], &result);
    right = right && result;
  }
  return right;
}

typedef struct Moved {
  Client client;
  GLXContext context;
} Moved;

static void* drawMoved(void* user) {
  Moved* moved = (Moved*)user;
  const int right = drawAll(&moved->client, moved->context);
  glXMakeCurrent(moved->client.display, None, NULL);
  return right ? moved : NULL;
}

static int moved(void) {
  Moved state = {openClient(&glx), NULL};
  state.context = contextFor(&state.client, NULL);
  pthread_t thread;
  void* result = NULL;
  const int here = drawMoved(&state) != NULL;
  pthread_create(&thread, NULL, drawMoved, &state);
  pthread_join(thread, &result);
  return here && result;
}

static int destroyed(void) {
  Client client = openClient(&glx);
  GLXContext context = contextFor(&client, NULL);
  glXMakeCurrent(client.display, client.window, context);
  drawFrame(&gl);
  glXDestroyContext(client.display, context);
  const int right =
      workload(&gl, showClient, &client); /* GLX 1.4, 3.3.7: it lives until it is no longer current */
  glXMakeCurrent(client.display, None, NULL);
  return right;
}

static int unmade(void) {
  Client client = openClient(&glx);
  GLXContext context = contextFor(&client, NULL);
  const int right = drawAll(&client, context);
  drawFrame(&gl);
  XDestroyWindow(client.display, client.window);
  XSync(client.display, False);
  glXMakeCurrent(client.display, None, NULL);
  glXDestroyContext(client.display, context);
  return right;
}

static int midframe(void) {
  Client client = openClient(&glx);
  const int right = drawAll(&client, contextFor(&client, NULL));
  glBegin(GL_TRIANGLES);
  glVertex3f(0, 0, 0);
  exit(!right);
}

static int waitFor(pid_t child) {
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static int forked(void) {
  Client client = openClient(&glx);
  GLXContext context = contextFor(&client, NULL);
  int right = drawAll(&client, context);
  glXMakeCurrent(client.display, None, NULL);
  const pid_t child = fork();
  if (child == 0) {
    Client own = openClient(&glx);
    _exit(!drawAll(&own, contextFor(&own, NULL)));
  }
  right = waitFor(child) && right;
  return drawAll(&client, context) && right;
}

static int executed(char** argv) {
  Client client = openClient(&glx);
  const int right = drawAll(&client, contextFor(&client, NULL));
  const pid_t child = fork();
  if (child == 0) {
    execl(argv[0], argv[0], "two", (char*)NULL);
    _exit(127);
  }
  return waitFor(child) && right;
}

int main(int argc, char** argv) {
  const char* way = argc > 1 ? argv[1] : "two";
  XInitThreads();
  gl = linkedGl();
  glx = linkedGlx();
  if (strcmp(way, "two") == 0) return !two();
  if (strcmp(way, "shared") == 0) return !shared();
  if (strcmp(way, "threads") == 0) return !threads();
  if (strcmp(way, "moved") == 0) return !moved();
  if (strcmp(way, "destroyed") == 0) return !destroyed();
  if (strcmp(way, "unmade") == 0) return !unmade();
  if (strcmp(way, "midframe") == 0) return !midframe();
  if (strcmp(way, "fork") == 0) return !forked();
  if (strcmp(way, "exec") == 0) return !executed(argv);
  return fprintf(stderr, "what is %s?\n", way), 2;
}
