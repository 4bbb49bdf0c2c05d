#include "desktop/trial/question_screen.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <span>

#include "desktop/trial/message_screen.h"

namespace felt::desktop {
namespace {

/// One item; the texts are translated when they are shown.
struct QuestionItem {
  const char* name;      // "" if the item consists of its ends only
  const char* question;  // likewise
  const char* left;
  const char* right;
};

constexpr const char* kContext = "QuestionScreen";

constexpr QuestionItem kTlxItems[] = {
    {QT_TRANSLATE_NOOP("QuestionScreen", "Mental demand"),
     QT_TRANSLATE_NOOP("QuestionScreen", "How mentally demanding was the task?"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very low"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very high")},
    {QT_TRANSLATE_NOOP("QuestionScreen", "Physical demand"),
     QT_TRANSLATE_NOOP("QuestionScreen", "How physically demanding was the task?"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very low"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very high")},
    {QT_TRANSLATE_NOOP("QuestionScreen", "Temporal demand"),
     QT_TRANSLATE_NOOP("QuestionScreen", "How hurried or rushed was the pace of the task?"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very low"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very high")},
    {QT_TRANSLATE_NOOP("QuestionScreen", "Performance"),
     QT_TRANSLATE_NOOP("QuestionScreen",
                       "How successful were you in accomplishing what you were asked to do?"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Perfect"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Failure")},
    {QT_TRANSLATE_NOOP("QuestionScreen", "Effort"),
     QT_TRANSLATE_NOOP("QuestionScreen",
                       "How hard did you have to work to accomplish your level of performance?"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very low"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very high")},
    {QT_TRANSLATE_NOOP("QuestionScreen", "Frustration"),
     QT_TRANSLATE_NOOP("QuestionScreen",
                       "How insecure, discouraged, irritated, stressed and annoyed were you?"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very low"),
     QT_TRANSLATE_NOOP("QuestionScreen", "Very high")},
};

constexpr QuestionItem kUeqItems[] = {
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "obstructive"),
     QT_TRANSLATE_NOOP("QuestionScreen", "supportive")},
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "complicated"),
     QT_TRANSLATE_NOOP("QuestionScreen", "easy")},
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "inefficient"),
     QT_TRANSLATE_NOOP("QuestionScreen", "efficient")},
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "confusing"),
     QT_TRANSLATE_NOOP("QuestionScreen", "clear")},
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "boring"),
     QT_TRANSLATE_NOOP("QuestionScreen", "exciting")},
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "not interesting"),
     QT_TRANSLATE_NOOP("QuestionScreen", "interesting")},
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "conventional"),
     QT_TRANSLATE_NOOP("QuestionScreen", "inventive")},
    {"", "", QT_TRANSLATE_NOOP("QuestionScreen", "usual"),
     QT_TRANSLATE_NOOP("QuestionScreen", "leading edge")},
};

constexpr int kTlxMarks = 21;
constexpr double kTlxStep = 5.0;
constexpr int kUeqMarks = 7;

std::span<const QuestionItem> items_of(Questionnaire form) {
  if (form == Questionnaire::kNasaTlx) return kTlxItems;
  return kUeqItems;
}

QString item_text(const char* text) {
  return *text ? QCoreApplication::translate(kContext, text) : QString();
}

}  // namespace

QuestionScreen::QuestionScreen(QWidget* parent)
    : QWidget(parent), title_(new QLabel), text_(new QLabel), button_(new QPushButton) {
  title_->setFont(larger_font(*this, 1.8));
  text_->setFont(larger_font(*this, 1.2));
  button_->setFont(larger_font(*this, 1.4));
  button_->setMinimumSize(220, 56);
  button_->setFocusPolicy(Qt::NoFocus);
  for (QLabel* label : {title_, text_}) label->setTextFormat(Qt::PlainText);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  layout->addStretch(1);
  layout->addWidget(title_, 0, Qt::AlignHCenter);
  layout->addWidget(text_, 0, Qt::AlignHCenter);
  layout->addSpacing(10);
  layout->addWidget(button_, 0, Qt::AlignHCenter);
  layout->addStretch(1);
  connect(button_, &QPushButton::clicked, this, &QuestionScreen::answered);
}

void QuestionScreen::show_form(Questionnaire form, const QString& condition) {
  form_ = form;
  title_->setText(condition.isEmpty() ? tr("Your opinion on this session")
                                      : tr("Your opinion on %1").arg(condition));
  text_->setText(form == Questionnaire::kNasaTlx
                     ? tr("For each question, choose the mark that matches your experience best.")
                     : tr("For each line, choose the circle that matches your impression best."));
  button_->setText(tr("Next"));
  add_items();
}

void QuestionScreen::add_items() {
  delete items_;
  scales_.clear();
  items_ = new QWidget;
  auto* grid = new QGridLayout(items_);
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(4);
  const bool is_tlx = form_ == Questionnaire::kNasaTlx;
  int row = 0;
  for (const QuestionItem& item : items_of(form_)) {
    const QString left = item_text(item.left), right = item_text(item.right);
    if (*item.question) {
      auto* question = new QLabel(
          QStringLiteral("<b>%1</b>&nbsp;&nbsp; %2")
              .arg(item_text(item.name).toHtmlEscaped(), item_text(item.question).toHtmlEscaped()));
      question->setFont(larger_font(*this, 1.1));
      question->setContentsMargins(0, 12, 0, 0);
      grid->addWidget(question, row++, 0, 1, 3, Qt::AlignHCenter);
    }
    auto* scale = is_tlx ? new AnswerScale(kTlxMarks, AnswerScale::Look::kLines)
                         : new AnswerScale(kUeqMarks, AnswerScale::Look::kCircles);
    scale->setAccessibleName(*item.name ? item_text(item.name)
                                        : left + QStringLiteral(" – ") + right);
    for (const auto& [text, column] : {std::pair{left, 0}, {right, 2}}) {
      auto* label = new QLabel(text);
      label->setFont(larger_font(*this, 1.1));
      grid->addWidget(label, row, column,
                      Qt::AlignVCenter | (column == 0 ? Qt::AlignRight : Qt::AlignLeft));
    }
    grid->addWidget(scale, row++, 1);
    connect(scale, &AnswerScale::chosen, this, [this] {
      button_->setEnabled(std::all_of(scales_.begin(), scales_.end(),
                                      [](const AnswerScale* s) { return s->choice(); }));
    });
    scales_.push_back(scale);
  }
  // The columns beside the scales are equally wide, so that the scales are in the middle.
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(2, 1);
  auto* layout = static_cast<QVBoxLayout*>(this->layout());
  layout->insertWidget(layout->indexOf(button_) - 1, items_, 0, Qt::AlignHCenter);
  button_->setEnabled(false);
  scales_.front()->setFocus();
}

std::vector<double> QuestionScreen::answers() const {
  std::vector<double> values;
  for (const AnswerScale* scale : scales_) {
    const int mark = scale->choice().value_or(0);
    values.push_back(form_ == Questionnaire::kNasaTlx ? kTlxStep * mark : mark + 1.0);
  }
  return values;
}

void QuestionScreen::proceed() {
  if (button_->isEnabled()) Q_EMIT answered();
}

}  // namespace felt::desktop
