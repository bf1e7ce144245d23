#pragma once
#include "Steps/FaultLine.h"
#include "Steps/ObjectChooser.h"
#include "Steps/ObjectDraft.h"
#include "Steps/PartStatus.h"
#include "Steps/RecipeForm.h"

#include <QVBoxLayout>
#include <QWidget>

namespace hasp
{

/// A form for the objects of one kind that parts are made of: which one, whether its part is in
/// date, and what a kind asks for besides, in the derived class. A finished edit is one step of the
/// plan, if the plan takes it; else it stays in the form, and the form says why. A new one comes
/// into the plan with the edit that completes it.
///
/// Threads: RENDER. Cost: a copy of the plan for each finished edit.
template <typename T>
class ObjectBox : public QWidget
{
public:
  /// `prefix`: of widgets' names. `noun`: "guide", for the names of steps.
  ObjectBox(Planner& planner, const QString& prefix, const QString& fresh, const QString& noun,
    QWidget* parent)
    : QWidget(parent),
      Of(planner),
      Noun(noun),
      Draft(planner),
      Column(new QVBoxLayout(this)),
      List(new ObjectChooser(planner, prefix, fresh,
        [](const Plan& plan) { return IdsOf(plan.*PlanListOf<T>().objects); })),
      Status(new PartStatus(planner, prefix)),
      Fault(new FaultLine(prefix))
  {
    this->Column->setContentsMargins(0, 0, 0, 0);
    this->Column->addWidget(this->List);
    this->Column->addWidget(this->Status);
    this->Column->addWidget(this->Fault);
    connect(this->List, &ObjectChooser::ChosenChanged, this, [this](PlanId id) { this->Show(id); });
    connect(this->List, &ObjectChooser::NewAsked, this, [this] { this->BeginNew(); });
    connect(&planner.plan, &PlanSession::Replaced, this,
      [this]
      {
        this->Draft.Show(0); // one that is new, too: it is made of objects of the old plan
        this->List->Choose(0);
      });
    connect(&planner.plan, &PlanSession::Changed, this, [this] { this->Follow(); });
  }

  PlanId Chosen() const { return this->Draft.Id(); }

protected:
  virtual T Fresh() = 0;   ///< a new one, as far as it is known
  virtual void Begun() {}  ///< a new one is shown: what is to be touched first is in hand
  virtual void Fill() = 0; ///< all widgets as the draft has it
  /// Why it cannot be made though the plan takes it, as far as that is known; empty: it can.
  virtual QString WhyNotMade() { return {}; }

  /// One of its forms: asked to fill itself, and known to the line of faults.
  RecipeForm* Add(RecipeForm* form)
  {
    this->Forms.push_back(form);
    this->Fault->Know(form);
    return form;
  }
  void FillForms()
  {
    for (RecipeForm* form : this->Forms)
    {
      form->Refresh();
      form->setEnabled(this->Draft.IsShown());
    }
  }
  void ShowFault(const QString& text) { this->Fault->Say(text); }
  /// Into the plan, or says why not. `label`: of the step, where it is no plain change.
  void Put(const QString& label = {})
  {
    if (!this->Draft.IsShown())
      return;
    if (this->Draft.Fault().isEmpty() && this->Draft.Put(label.isEmpty() ? this->Label() : label))
      this->List->Choose(this->Draft.Id());
    this->Fill();
    this->Judge();
    this->Status->Show(this->Draft.Id());
  }
  void Show(PlanId id)
  {
    if (id == this->Draft.Id() && this->Draft.IsShown())
      return;
    if (id == 0 && this->Draft.IsNew())
      return; // it is being made
    this->Draft.Show(id);
    this->Fill();
    this->Judge();
    this->Status->Show(id);
  }
  void BeginNew()
  {
    this->List->Choose(0);
    this->Draft.Begin(this->Fresh());
    this->ShowFault({});
    this->Fill();
    this->Status->Show(0);
    this->Begun();
  }

  Planner& Of;
  QString Noun;
  ObjectDraft<T> Draft;
  QVBoxLayout* Column;
  ObjectChooser* List;
  PartStatus* Status;
  FaultLine* Fault;
  std::vector<RecipeForm*> Forms;

private:
  void Follow()
  {
    this->Draft.Follow();
    this->Fill();
    this->Judge();
    this->Status->Show(this->Draft.Id());
  }
  /// What is not right: the plan would not take it, or it cannot be made.
  void Judge()
  {
    const QString fault = this->Draft.IsShown() ? this->Draft.Fault() : QString();
    this->ShowFault(fault.isEmpty() && this->Draft.IsShown() ? this->WhyNotMade() : fault);
  }
  QString Label() const
  {
    return this->Draft.IsNew() ? QWidget::tr("Add a %1").arg(this->Noun)
                               : QWidget::tr("Change %1 %2").arg(this->Noun).arg(this->Draft.Id());
  }
};

} // namespace hasp
