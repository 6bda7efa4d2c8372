// The live image with its tools: picking objects, light and focus by the mouse, the real OpenGL's image
// beside GLuRay's, saving. GUI thread.
#pragma once
#include "model/comparison.h"
#include "pages/live/light_drag.h"
#include "pages/live/live_image.h"

#include <QWidget>

class QGridLayout;
class QToolButton;

namespace gluray::panel {

class LiveView : public QWidget {
  Q_OBJECT

 public:
  LiveView(Controls& controls, QWidget* parent);
  LiveImage& liveImage() { return *image_; }
  /// The real OpenGL's, while it is compared; null: there is none.
  const QImage& openGlImage() const { return comparison_.image(); }
  /// Leaves out the button that shows it in a window of its own: it is in that window.
  void isLarge();
  /// Saves the window's image in full size as a PNG file.
  void saveTo(const QString& file);

 signals:
  void said(const QString& line);
  /// The user has clicked where the program draws the object; 0: none.
  void picked(int program, uint32_t object);
  void enlarged();

 private:
  QToolButton* addButton(QGridLayout* grid, int row, const char* name, const QString& text,
                         const QString& key, const QString& help);
  void makeTools(QGridLayout* grid);
  void makeButtons(QGridLayout* grid);
  void point(const ImagePoint& at, LiveImage::Stage stage);
  void pick(const ImagePoint& at);
  void chooseFile();
  void enable();

  Controls& controls_;
  LiveImage* image_;
  LightDrag light_;
  Comparison comparison_;
  QToolButton *lightTool_ = nullptr, *focusTool_ = nullptr, *compareTool_ = nullptr, *renew_ = nullptr;
  QToolButton *save_ = nullptr, *film_ = nullptr, *enlarge_ = nullptr;
};

}  // namespace gluray::panel
