#pragma once
#include <nlohmann/json_fwd.hpp>

#include <QStringList>

namespace hasp
{

/// Each visible widget that has a name (objectName), window by window:
///
///   name, class
///   rect      [x, y, w, h] on the screen, pixels
///   shown     the part of it that its parents do not cut off; none of it: [x, y, 0, 0]
///   area      where that is not all of it: what is shown of the scrolled area that it is in
///   hit       of check boxes and their like, which are clicked on at an end
///   enabled
///   checked   of what can be checked
///   text      of buttons, labels, and spin boxes, without "&"
///   mnemonic  the letter that is pressed with Alt: of its text, or of the label before it
///   value     of spin boxes, sliders and progress bars
///   index, count   of a combo box; of a line of text `length` alone
///   rows      of lists, trees and tables: {row, column, rect, selected}, `id` (a number of Qt's
///             UserRole) and `checked` where they are there; of tabs {row, rect, selected, text}
///
/// Besides widgets: the actions of menus (class QAction), the list of a combo box that is open as
/// NAME.list, and the standard buttons of a dialog as NAME.ok, NAME.cancel, …, and what a message
/// box says as NAME.text; NAME is "dialog" if the dialog has none. A tool button is called as its
/// action. What Qt names itself is left out.
///
/// `words`: texts that hold one of them, as a whole word in whatever case, are left out, and so is
/// the text of a widget with the property "userText" and of all in a dialog that chooses files.
/// Threads: RENDER.
nlohmann::ordered_json DescribeWidgets(const QStringList& words);

} // namespace hasp
