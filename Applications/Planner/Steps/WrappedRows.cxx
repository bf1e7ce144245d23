#include "Steps/WrappedRows.h"

#include <QHeaderView>
#include <QTreeView>

namespace hasp
{

WrappedRows::WrappedRows(QTreeView& tree) : QStyledItemDelegate(&tree), Tree(tree)
{
  tree.setItemDelegate(this);
  tree.setWordWrap(true);
  tree.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(tree.header(), &QHeaderView::sectionResized, &tree, &QTreeView::doItemsLayout);
}

QSize WrappedRows::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
  int taken = this->Tree.rootIsDecorated() ? this->Tree.indentation() : 0;
  for (QModelIndex above = index.parent(); above.isValid(); above = above.parent())
    taken += this->Tree.indentation();
  const QStyle* style = this->Tree.style();
  if (index.data(Qt::CheckStateRole).isValid())
    taken += style->pixelMetric(QStyle::PM_IndicatorWidth, &option, &this->Tree) +
             style->pixelMetric(QStyle::PM_CheckBoxLabelSpacing, &option, &this->Tree);
  QStyleOptionViewItem narrow = option;
  narrow.rect.setSize({ this->Tree.columnWidth(index.column()) - taken, 1 });
  return QStyledItemDelegate::sizeHint(narrow, index);
}

} // namespace hasp
