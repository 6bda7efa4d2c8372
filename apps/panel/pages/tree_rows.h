// Rows of a table of texts that is shown anew again and again. GUI thread.
#pragma once
#include <QStringList>
#include <vector>

class QTreeWidget;

namespace gluray::panel {

/// Makes the rows those; what is selected, by the text of the first column, stays so, as does what is in
/// sight.
void setRows(QTreeWidget& tree, const std::vector<QStringList>& rows);

}  // namespace gluray::panel
