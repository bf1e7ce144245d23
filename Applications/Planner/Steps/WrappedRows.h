#pragma once
#include <QStyledItemDelegate>

class QTreeView;

namespace hasp
{

/// Rows of a tree of one column that are as high as their words need at its width: Qt's own are a
/// line high, and cut off what is longer. Threads: RENDER.
class WrappedRows : public QStyledItemDelegate
{
  Q_OBJECT
public:
  /// The tree, which owns it, follows its own width from now on.
  explicit WrappedRows(QTreeView& tree);

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
  QTreeView& Tree;
};

} // namespace hasp
