// SPDX-License-Identifier: Apache-2.0
#include "jounce/edit/editor.hpp"

#include <charconv>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "jounce/design/convert.hpp"
#include "jounce/design/detail/fit.hpp"
#include "jounce/design/detail/law_guide.hpp"
#include "jounce/lint/committed.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/web/gate.hpp"

#include "edit/src/analysis.hpp"
#include "edit/src/change.hpp"
#include "edit/src/exports.hpp"
#include "edit/src/gallery.hpp"
#include "edit/src/jobs/optimum_job.hpp"
#include "edit/src/jobs/proof_job.hpp"
#include "edit/src/jobs/stream_job.hpp"
#include "edit/src/json_reader.hpp"
#include "edit/src/only_one.hpp"
#include "edit/src/page.hpp"
#include "edit/src/session.hpp"

namespace jounce {
namespace {

using edit_detail::Analysis;
using edit_detail::Job;
using edit_detail::Json;
using edit_detail::JsonReader;
using edit_detail::or_null;
using edit_detail::StreamOffer;
using edit_detail::StreamRequest;
using edit_detail::text_of;
using web::Answer;
using web::Request;

constexpr std::size_t most_text = std::size_t{4} << 20U;  ///< bytes of a request
constexpr auto poll_interval = std::chrono::milliseconds(250);

Answer rejected(int status, const std::string& reason) {
  return {status, text_of(Json{{"ok", false}, {"reason", reason}})};
}

/// An answer to a request that was obeyed: {"ok": true, ...}.
Json obeyed() {
  return {{"ok", true}};
}

Answer answer_of(const Json& value) {
  return {200, text_of(value)};
}

const char* word_of(EditSession::OnDisk state) {
  switch (state) {
    case EditSession::OnDisk::changed:
      return "changed";
    case EditSession::OnDisk::missing:
      return "missing";
    case EditSession::OnDisk::same:
      break;
  }
  return "same";
}

Json progress_of(const Job::State& job) {
  return {{"running", job.running},
          {"done", job.done},
          {"step", job.step},
          {"error", job.outcome.error}};
}

Json stream_of(const Job::State& stream) {
  const Job::Outcome& outcome = stream.outcome;
  return {{"running", stream.running},
          {"done", stream.done},
          {"step", stream.step},
          {"started", outcome.ok},
          {"text", outcome.error.empty() ? outcome.text : outcome.error}};
}

/// `current`: true if the job began with the present text.
Json proof_of(const Job::State& proof, bool current) {
  Json object = progress_of(proof);
  object["current"] = current;
  return object;
}

std::size_t axis_of(const Request& request) {
  const std::string text = request.value("axis");
  std::size_t axis = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), axis);
  if (error == std::errc() ? end != text.data() + text.size() : !text.empty())
    throw InputError("axis", text, "must be the number of an axis, from 0");
  return axis;
}

}  // namespace

struct Editor::Impl {
  Impl(const std::string& file, web::Listening listening,
       std::map<std::string, std::string> its_templates)
      : only_one((edit_detail::require_spec(file), file)),
        session(file),
        templates(std::move(its_templates)),
        token(web::new_token()),
        server(std::move(listening), token,
               {.files = {{"/", "text/html; charset=utf-8", edit_detail::page()},
                          {"/edit.js", "text/javascript; charset=utf-8", edit_detail::script()},
                          {"/edit.css", "text/css; charset=utf-8", edit_detail::style()}},
                .commands = commands(),
                .event = [this](std::int64_t& seen) { return event(seen); },
                .obey = [this](const Request& request) { return answer(request); },
                .urgent = [](const Request& /*request*/) { return false; },
                .most_body = most_text,
                .events_need_token = true}) {
    watcher = std::thread([this] { watch(); });
  }

  ~Impl() {
    {
      const std::scoped_lock lock(mutex);
      ending = true;
    }
    ended.notify_all();
    watcher.join();
  }

  void watch() {
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, poll_interval, [this] { return ending; })) session.poll();
  }

  // ---- events: the number of the state, and the progress of the jobs ----------------------------

  std::string event(std::int64_t& seen) {
    const std::scoped_lock lock(mutex);
    std::string text =
        text_of(Json{{"revision", session.revision()},
                     {"optimum", optimizer ? progress_of(optimizer->state()) : Json()},
                     {"proof", proof ? proof_of(proof->state(), is_proof_current()) : Json()},
                     {"stream", stream ? stream_of(stream->state()) : Json()}});
    const auto hash = static_cast<std::int64_t>(std::hash<std::string>{}(text) | 1U);  // never 0
    return std::exchange(seen, hash) == hash ? "" : text;
  }

  // ---- requests ---------------------------------------------------------------------------------

  Answer answer(const Request& request) {
    try {
      const Route* const route = route_of(request);
      if (route == nullptr) return rejected(404, "there is no such request: " + request.path);
      if (const auto* get = std::get_if<Get>(&route->handler)) return (this->**get)(request);
      return (this->*std::get<Post>(route->handler))(JsonReader("request", request.body));
    } catch (const InputError& error) {
      return rejected(400, error.what());
    } catch (const std::system_error& error) {
      return rejected(500, error.what());
    }
  }

  using Get = Answer (Impl::*)(const Request& request);
  using Post = Answer (Impl::*)(const JsonReader& body);
  /// A request, and the function that obeys it.
  struct Route {
    const char* method;
    const char* path;
    std::variant<Get, Post> handler;
  };
  static const std::vector<Route>& routes() {
    static const std::vector<Route> all{{"GET", "/document", &Impl::get_document},
                                        {"POST", "/document", &Impl::replace},
                                        {"POST", "/change", &Impl::change},
                                        {"POST", "/preview", &Impl::preview},
                                        {"POST", "/undo", &Impl::undo},
                                        {"POST", "/redo", &Impl::redo},
                                        {"POST", "/save", &Impl::save},
                                        {"POST", "/conflict", &Impl::resolve},
                                        {"GET", "/laws", &Impl::laws},
                                        {"GET", "/forms", &Impl::forms},
                                        {"GET", "/difference", &Impl::difference},
                                        {"GET", "/table", &Impl::table},
                                        {"GET", "/conversion", &Impl::conversion},
                                        {"GET", "/report", &Impl::report},
                                        {"GET", "/templates", &Impl::gallery},
                                        {"POST", "/fit", &Impl::fit},
                                        {"POST", "/optimize", &Impl::optimize},
                                        {"GET", "/optimum", &Impl::optimum},
                                        {"POST", "/optimum", &Impl::end_optimum},
                                        {"POST", "/validate", &Impl::validate},
                                        {"GET", "/proof", &Impl::proof_state},
                                        {"POST", "/proof", &Impl::end_proof},
                                        {"GET", "/stream", &Impl::stream_state},
                                        {"POST", "/stream", &Impl::send}};
    return all;
  }

  /// "GET /document" and so on.
  static std::vector<std::string> commands() {
    std::vector<std::string> all;
    for (const Route& route : routes()) all.push_back(std::string(route.method) + " " + route.path);
    return all;
  }

  static const Route* route_of(const Request& request) {
    const std::string_view method = request.is_get ? "GET" : "POST";
    for (const Route& route : routes())
      if (route.method == method && route.path == request.path) return &route;
    return nullptr;
  }

  Answer get_document(const Request& /*request*/) { return document(); }
  Answer undo(const JsonReader& body) {
    return step(body, &EditSession::undo, "there is nothing to undo");
  }
  Answer redo(const JsonReader& body) {
    return step(body, &EditSession::redo, "there is nothing to redo");
  }
  Answer save(const JsonReader& body) {
    return step(body, &EditSession::save, "the file has changed on the disk: resolve the conflict");
  }
  Answer laws(const Request& /*request*/) { return {200, laws_json()}; }
  Answer forms(const Request& /*request*/) { return answer_of(form_names()); }
  Answer gallery(const Request& /*request*/) { return {200, edit_detail::gallery(templates)}; }
  Answer report(const Request& request) {
    return {200, edit_detail::exported_report(path_of(), text(), axis_of(request)),
            "text/html; charset=utf-8"};
  }

  std::string text() {
    const std::scoped_lock lock(mutex);
    return session.text();
  }
  [[nodiscard]] const std::string& path_of() const { return session.path(); }

  /// The state of the session, with the analysis of its text.
  Answer document() {
    Json out = obeyed();
    std::string present;
    {
      const std::scoped_lock lock(mutex);
      present = session.text();
      const bool conflict = session.on_disk() == EditSession::OnDisk::changed;
      out.update({{"revision", session.revision()},
                  {"file", session.path()},
                  {"text", present},
                  {"saved", session.is_saved()},
                  {"on_disk", word_of(session.on_disk())},
                  {"file_text", conflict ? Json(session.file_text()) : Json()},
                  {"recovered", session.is_recovered()},
                  {"undo", or_null(session.undo_label())},
                  {"redo", or_null(session.redo_label())},
                  {"side_file", session.side_file()},
                  {"side_error", session.side_error()}});
    }
    add_to(out, *analysis(present));
    return answer_of(out);
  }

  /// The analysis of the newest text is kept: several pages show the same text.
  std::shared_ptr<const Analysis> analysis(const std::string& of) {
    {
      const std::scoped_lock lock(kept_mutex);
      if (kept && kept->first == of) return kept->second;
    }
    auto made = std::make_shared<const Analysis>(edit_detail::analysis_of(path_of(), of));
    const std::scoped_lock lock(kept_mutex);
    kept.emplace(of, made);
    return made;
  }

  Answer conflict_of_revisions() {
    return rejected(
        409,
        "the text has another revision by now: read /document, then decide whether to repeat the "
        "change");
  }

  bool store(std::int64_t revision, std::string next, std::string label) {
    const std::scoped_lock lock(mutex);
    return session.set(revision, std::move(next), std::move(label));
  }

  Answer replace(const JsonReader& body) {
    body.require_only({"revision", "text"});
    if (!store(body.whole("revision"), body.word("text"), "edit the text"))
      return conflict_of_revisions();
    return document();
  }

  Answer change(const JsonReader& body) {
    body.require_only({"revision", "change"});
    auto [next, label] = edit_detail::changed(path_of(), text(), body.object("change"));
    if (!store(body.whole("revision"), std::move(next), std::move(label)))
      return conflict_of_revisions();
    return document();
  }

  /// The analysis of a change that is not made.
  Answer preview(const JsonReader& body) {
    body.require_only({"change"});
    const std::string next = edit_detail::changed(path_of(), text(), body.object("change")).text;
    Json out = obeyed();
    out["text"] = next;
    add_to(out, edit_detail::analysis_of(path_of(), next));
    return answer_of(out);
  }

  Answer step(const JsonReader& body, bool (EditSession::*act)(), const char* objection) {
    body.require_only({"revision"});
    {
      const std::scoped_lock lock(mutex);
      if (body.whole("revision") != session.revision()) return conflict_of_revisions();
      if (!(session.*act)()) return rejected(409, objection);
    }
    return document();
  }

  Answer resolve(const JsonReader& body) {
    body.require_only({"revision", "use"});
    const std::string use = body.word("use");
    if (use != "file" && use != "mine") throw InputError("use", use, "must be file or mine");
    {
      const std::scoped_lock lock(mutex);
      if (body.whole("revision") != session.revision()) return conflict_of_revisions();
      use == "file" ? session.use_file() : session.use_mine();
    }
    return document();
  }

  // ---- exports ----------------------------------------------------------------------------------

  /// Fits a cam to measured points; changes nothing.
  Answer fit(const JsonReader& body) {
    body.require_only({"name", "points", "tolerance", "period", "master_unit", "position_unit"});
    const auto given = [&](const char* key) { return body.has(key) ? body.word(key) : ""; };
    const FittedCam fitted = fitted_cam(body.word("points"), body.word("name"),
                                        {.tolerance = given("tolerance"),
                                         .period = given("period"),
                                         .master_unit = given("master_unit"),
                                         .position_unit = given("position_unit")});
    Json out = obeyed();
    out.update({{"spec", fitted.text}, {"text", fit_text(fitted)}, {"within", fitted.ok()}});
    edit_detail::add_difference(out, path_of(), text(), fitted.text);
    return answer_of(out);
  }

  Answer difference(const Request& request) {
    const std::string against = request.value("against");
    if (!against.empty() && against != "file" && against != "head")
      throw InputError("against", against, "must be file or head");
    std::string before = against == "head" ? committed_text(path_of()) : "";
    std::string now;
    {
      const std::scoped_lock lock(mutex);
      if (against != "head")
        before = session.on_disk() == EditSession::OnDisk::changed ? session.file_text()
                                                                   : session.saved_text();
      now = session.text();
    }
    Json out = obeyed();
    out["before"] = before;
    edit_detail::add_difference(out, path_of(), before, now);
    return answer_of(out);
  }

  edit_detail::Exported exported(const Request& request) {
    edit_detail::ExportRequest wanted{.axis = axis_of(request),
                                      .over = request.value("over"),
                                      .target = {.tolerance = request.value("tolerance"),
                                                 .x_step = request.value("x_step"),
                                                 .p_step = request.value("p_step")}};
    if (const std::string form = request.value("form"); !form.empty()) wanted.form = form;
    return edit_detail::exported_table(path_of(), text(), wanted);
  }

  Answer table(const Request& request) {
    edit_detail::Exported made = exported(request);
    if (!made.fits) return rejected(400, made.text);
    const bool is_text = made.file.find('\0') == std::string::npos;
    return {200, std::move(made.file),
            is_text ? "text/plain; charset=utf-8" : "application/octet-stream"};
  }

  Answer conversion(const Request& request) {
    const edit_detail::Exported made = exported(request);
    Json out = obeyed();
    out.update({{"text", made.text}, {"ending", made.ending}, {"fits", made.fits}});
    return answer_of(out);
  }

  // ---- the optimizer ----------------------------------------------------------------------------

  Answer optimize(const JsonReader& body) {
    body.require_only({});
    std::string given = text();
    const std::scoped_lock lock(mutex);
    if (optimizer && optimizer->state().running)
      return rejected(409, "the optimizer is running: stop it first");
    optimizer.reset();
    optimizer = edit_detail::optimum_job(path_of(), given);
    return answer_of(obeyed());
  }

  /// The state of the optimizer, and its result with the comparison of both curves.
  Answer optimum(const Request& /*request*/) {
    Job::State state;
    std::string given;
    {
      const std::scoped_lock lock(mutex);
      if (!optimizer) return rejected(404, "no optimization was started");
      state = optimizer->state();
      given = optimizer->given();
    }
    const Job::Outcome& best = state.outcome;
    Json out = obeyed();
    out.update(progress_of(state));
    out.update({{"text", best.text}, {"broken", best.broken}, {"spec", or_null(best.spec)}});
    if (best.spec) edit_detail::add_difference(out, path_of(), given, *best.spec);
    return answer_of(out);
  }

  Answer end_optimum(const JsonReader& body) {
    body.require_only({"do", "revision"});
    const std::string what = body.word("do");
    std::unique_ptr<Job> discarded;  // ends after the lock: its destructor waits for the work
    {
      const std::scoped_lock lock(mutex);
      if (!optimizer) return rejected(404, "no optimization was started");
      if (what == "stop")
        optimizer->stop();
      else if (what == "discard")
        discarded = std::move(optimizer);
      else if (what == "take") {
        if (auto objection = take_optimum(body)) return *objection;
      } else
        throw InputError("do", what, "must be stop, take or discard");
    }
    return document();
  }

  std::optional<Answer> take_optimum(const JsonReader& body) {
    Job::State state = optimizer->state();
    if (!state.outcome.spec) return rejected(409, "there is no result to take");
    if (session.text() != optimizer->given())
      return rejected(409,
                      "the text has changed since the optimizer began: undo the changes, or start "
                      "the optimizer again");
    if (!session.set(body.whole("revision"), *std::move(state.outcome.spec), "optimize"))
      return conflict_of_revisions();
    optimizer.reset();
    return std::nullopt;
  }

  // ---- `jounce validate` ------------------------------------------------------------------------

  Answer validate(const JsonReader& body) {
    body.require_only({});
    {
      const std::scoped_lock lock(mutex);
      if (is_proving()) return rejected(409, already_proving);
    }
    std::unique_ptr<Job> made = edit_detail::proof_job(path_of(), text());
    const std::scoped_lock lock(mutex);
    if (is_proving()) return rejected(409, already_proving);
    std::swap(proof, made);  // the previous one ends after the lock
    return answer_of(obeyed());
  }

  static constexpr const char* already_proving = "a validation is running: stop it first";

  /// Call with the lock.
  [[nodiscard]] bool is_proving() const { return proof && proof->state().running; }
  [[nodiscard]] bool is_proof_current() const { return proof->given() == session.text(); }

  Answer proof_state(const Request& /*request*/) {
    const std::scoped_lock lock(mutex);
    if (!proof) return rejected(404, "no validation was started");
    const Job::State state = proof->state();
    Json out = obeyed();
    out.update(proof_of(state, is_proof_current()));
    out.update({{"proven", state.outcome.ok}, {"text", state.outcome.text}});
    return answer_of(out);
  }

  Answer end_proof(const JsonReader& body) {
    body.require_only({"do"});
    const std::string what = body.word("do");
    std::unique_ptr<Job> discarded;  // ends after the lock
    const std::scoped_lock lock(mutex);
    if (!proof) return rejected(404, "no validation was started");
    if (what == "stop")
      proof->stop();
    else if (what == "discard")
      discarded = std::move(proof);
    else
      throw InputError("do", what, "must be stop or discard");
    return answer_of(obeyed());
  }

  // ---- a stream to an executor: never without the confirmation of an offer ----------------------

  Answer send(const JsonReader& body) {
    const std::string what = body.word("do");
    if (what == "offer") return offer_stream(body);
    if (what == "confirm") return confirm_stream(body);
    if (what != "cancel") throw InputError("do", what, "must be offer, confirm or cancel");
    body.require_only({"do"});
    const std::scoped_lock lock(mutex);
    offer.reset();
    if (stream) stream->stop();
    return answer_of(obeyed());
  }

  /// Makes the table and asks the axis for its state. A new offer replaces the one before.
  Answer offer_stream(const JsonReader& body) {
    body.require_only({"do", "axis", "to", "url", "key", "live", "start_at", "at_next_cut",
                       "keep_velocity", "relative"});
    StreamRequest wanted{.axis = body.index("axis", 0, most_text),
                         .executor = body.word("to"),
                         .link = {},
                         .play = {.live = body.flag("live"),
                                  .at_next_cut = body.flag("at_next_cut"),
                                  .at_master = body.has("start_at"),
                                  .keep_velocity = body.flag("keep_velocity")},
                         .start_at = body.optional_number("start_at"),
                         .relative = body.flag("relative")};
    if (body.has("url")) wanted.link.url = body.word("url");
    if (body.has("key")) wanted.link.key = body.word("key");
    StreamOffer made = edit_detail::stream_offer(path_of(), text(), wanted);
    Json out = obeyed();
    add_to(out, made);
    const std::scoped_lock lock(mutex);
    offer = std::move(made);
    return answer_of(out);
  }

  Answer confirm_stream(const JsonReader& body) {
    body.require_only({"do", "confirmation"});
    const std::scoped_lock lock(mutex);
    if (!offer || !web::same(offer->confirmation, body.word("confirmation")))
      return rejected(409, "this is not the confirmation of the newest offer: make an offer first");
    if (offer->text != session.text()) {
      offer.reset();
      return rejected(409, "the text has changed since the offer: make a new offer");
    }
    if (stream && stream->state().running)
      return rejected(409, "a stream is running: cancel it, or wait for its end");
    stream.reset();
    stream = edit_detail::stream_job(*std::exchange(offer, std::nullopt));
    return answer_of(obeyed());
  }

  Answer stream_state(const Request& /*request*/) {
    const std::scoped_lock lock(mutex);
    if (!stream) return rejected(404, "no stream was started");
    Json out = obeyed();
    out.update(stream_of(stream->state()));
    return answer_of(out);
  }

  edit_detail::OnlyOne only_one;
  std::mutex mutex;  // guards the session, the jobs and the offer
  EditSession session;
  const std::map<std::string, std::string> templates;
  std::unique_ptr<Job> optimizer;
  std::unique_ptr<Job> proof;
  std::optional<StreamOffer> offer;
  std::unique_ptr<Job> stream;
  std::mutex kept_mutex;  // guards the next one
  std::optional<std::pair<std::string, std::shared_ptr<const Analysis>>> kept;
  std::condition_variable ended;
  bool ending = false;
  std::thread watcher;
  const std::string token;
  web::Server server;  // last: its threads use the others
};

Editor::Editor(const std::string& file, web::Listening listening,
               std::map<std::string, std::string> templates)
    : impl_(std::make_unique<Impl>(file, std::move(listening), std::move(templates))) {}
Editor::~Editor() = default;

std::string Editor::address() const {
  return "http://127.0.0.1:" + std::to_string(impl_->server.port()) + "/#" + impl_->token;
}

bool Editor::is_saved() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->session.is_saved();
}

std::string Editor::side_file() const {
  return impl_->session.side_file();
}

}  // namespace jounce
