// Messages between a program and a worker on its machine, over a Line. Any thread.
#pragma once
#include "cluster/messages/codec.h"
#include "cluster/messages/fact_messages.h"
#include "cluster/messages/part_messages.h"

namespace gluray::cluster {

// From the program.

struct Hello {
  static constexpr uint16_t kType = 1;
  std::string version;  // of GLuRay
  std::string program;
  int32_t process = 0;
  // Its MPI job, whose other ranks have other parts of the scene; one rank: no MPI job.
  std::string mpiJob;
  int32_t rank = 0, ranks = 1;
};
/// An array whose sealed memory is attached.
struct ArrayComes {
  static constexpr uint16_t kType = 2;
  Hash128 name;
  uint64_t bytes = 0;
};
/// Later snapshots do not use these arrays, unless they are sent again.
struct ArraysGo {
  static constexpr uint16_t kType = 3;
  std::vector<Hash128> names;
};
/// A view of a frame, as the ranks of a program name it.
struct ViewName {
  uint64_t frame = 0;      // frameOf()
  glm::ivec4 viewport{0};  // Snapshot::camera's
  bool operator==(const ViewName&) const = default;
};
struct TraceRequest {
  static constexpr uint16_t kType = 4;
  uint64_t id = 0;    // rises
  uint64_t view = 0;  // Snapshot::view
  int32_t width = 0, height = 0;
  bool moving = false;      // a frame of an animation with light
  float fps = 24;           // frames a second that such frames aim at
  bool layered = false;     // Snapshot::layers is there
  bool meetsPeers = false;  // surfaces of the program's other ranks may block its light
  ViewName shown;           // of such light
  // The parts of other ranks belong to the image, too (setting gather).
  bool gathers = false;
  PartView part;
  uint64_t number = 0;          // Snapshot::number
  std::vector<Hash128> arrays;  // that the snapshot names, of a part
  uint32_t missColor = 0;       // Image::missColor
  std::vector<uint8_t> wanted;  // LightSampling::tiles; empty: all
  std::vector<std::byte> snapshot;
};
struct Cancel {
  static constexpr uint16_t kType = 5;
  uint64_t id = 0;
};
/// The program's displayed image of its last gathered snapshot, after all passes. The pixels, as in
/// planesIn(shape), are attached in sealed memory.
struct ImageShown {
  static constexpr uint16_t kType = 6;
  uint64_t number = 0;     // TraceRequest::number
  bool finished = false;   // no further passes
  uint32_t missColor = 0;  // Image::missColor
  ImageShape shape;
  LayerCounts layers;
};
/// Requests the properties of the job's ranks and hosts.
struct JobQuestion {
  static constexpr uint16_t kType = 50;
};

// From the worker.

struct Welcome {
  static constexpr uint16_t kType = 101;
  std::string refusal;             // reason for refusing this program; empty: accepted
  int32_t ranks = 1, threads = 1;  // of the job
};
/// Sign of life: the worker works on the image.
struct AtWork {
  static constexpr uint16_t kType = 102;
  uint64_t id = 0;
};
/// Attached memory for all further images of at most so many bytes.
struct ImageMemory {
  static constexpr uint16_t kType = 103;
  uint64_t bytes = 0;
};
struct ImageDone {
  static constexpr uint16_t kType = 104;
  uint64_t id = 0;
  bool whole = false;  // false: cancelled, or `error` says why
  bool improves = false;
  bool gathered = false;  // it also shows the surfaces of other ranks
  std::string error;
  std::string note;  // reason if expected surfaces of other ranks are missing; may be empty
  ImageShape shape;
  LayerCounts layers;
  scene::TraceCost cost;
};
/// Answers JobQuestion.
struct JobFacts {
  static constexpr uint16_t kType = 150;
  std::vector<RankFacts> ranks;  // in order, also those that have not answered
};

void fields(auto& archive, Like<Hello> auto& value) {
  auto& [version, program, process, mpiJob, rank, ranks] = value;
  archive(version, program, process, mpiJob, rank, ranks);
}
void fields(auto& archive, Like<ArrayComes> auto& value) {
  auto& [name, bytes] = value;
  archive(name, bytes);
}
void fields(auto& archive, Like<ArraysGo> auto& value) {
  auto& [names] = value;
  archive(names);
}
void fields(auto& archive, Like<ViewName> auto& value) {
  auto& [frame, viewport] = value;
  archive(frame, viewport);
}
void fields(auto& archive, Like<TraceRequest> auto& value) {
  auto& [id, view, width, height, moving, fps, layered, meetsPeers, shown, gathers, part, number, arrays,
         missColor, wanted, snapshot] = value;
  archive(id, view, width, height, moving, fps, layered, meetsPeers, shown, gathers, part, number, arrays,
          missColor, wanted, snapshot);
}
void fields(auto& archive, Like<Cancel> auto& value) {
  auto& [id] = value;
  archive(id);
}
void fields(auto& archive, Like<ImageShown> auto& value) {
  auto& [number, finished, missColor, shape, layers] = value;
  archive(number, finished, missColor, shape, layers);
}
void fields(auto&, Like<JobQuestion> auto&) {}
void fields(auto& archive, Like<Welcome> auto& value) {
  auto& [refusal, ranks, threads] = value;
  archive(refusal, ranks, threads);
}
void fields(auto& archive, Like<AtWork> auto& value) {
  auto& [id] = value;
  archive(id);
}
void fields(auto& archive, Like<ImageMemory> auto& value) {
  auto& [bytes] = value;
  archive(bytes);
}
void fields(auto& archive, Like<ImageDone> auto& value) {
  auto& [id, whole, improves, gathered, error, note, shape, layers, cost] = value;
  archive(id, whole, improves, gathered, error, note, shape, layers, cost);
}
void fields(auto& archive, Like<JobFacts> auto& value) {
  auto& [ranks] = value;
  archive(ranks);
}

}  // namespace gluray::cluster
