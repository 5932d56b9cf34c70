// SPDX-License-Identifier: Apache-2.0
#include "jounce/edit/editor.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/cam/laws/law.hpp"
#include "jounce/design/input.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/proof/proof.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::editor_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string feeder = R"(jounce = 1
kind = "cam"
name = "feeder"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "345"
end = { master = 100, slave = 50 }  # top
[limits]
geo_velocity = 1
)";

class Editors : public test::WithFolder {
 protected:
  Editors() {
    write_file(path, feeder);
    editor = std::make_unique<Editor>(path, web::Listening(0));
    const std::string address = editor->address();
    const auto mark = address.find('#');
    token = address.substr(mark + 1);
    client = std::make_unique<httplib::Client>(address.substr(0, mark - 1));
    client->set_read_timeout(30s);
  }

  [[nodiscard]] httplib::Headers headers() const { return {{"X-Jounce-Token", token}}; }

  json get(const std::string& target, int status = 200) {
    const auto answer = client->Get(target, headers());
    EXPECT_TRUE(answer) << target;
    EXPECT_EQ(answer->status, status) << target << answer->body;
    return json::parse(answer->body);
  }
  json post(const std::string& target, const json& body, int status = 200) {
    const auto answer = client->Post(target, headers(), body.dump(), "application/json");
    EXPECT_TRUE(answer) << target;
    EXPECT_EQ(answer->status, status) << target << answer->body;
    return json::parse(answer->body);
  }
  json change(const json& what, int status = 200) {
    return post("/change", {{"revision", get("/document")["revision"]}, {"change", what}}, status);
  }
  /// The finding of this rule.
  static json finding(const json& document, const std::string& rule) {
    for (const json& each : document["result"]["findings"])
      if (each["rule"] == rule) return each;
    ADD_FAILURE() << "no finding of the rule " << rule;
    return {};
  }
  /// Waits until the document fulfills a condition; the file is looked at four times a second.
  template <class Condition>
  json wait_for(Condition condition) {
    for (int turn = 0; turn < 200; ++turn) {
      json now = get("/document");
      if (condition(now)) return now;
      std::this_thread::sleep_for(50ms);
    }
    ADD_FAILURE() << "never";
    return get("/document");
  }

  /// The state of a job after its end.
  json ended(const std::string& job) {
    json state = get(job);
    for (int turn = 0; turn < 600 && state["running"]; ++turn) {
      std::this_thread::sleep_for(50ms);
      state = get(job);
    }
    EXPECT_EQ(state["running"], false) << job;
    return state;
  }

  const std::string path = in("feeder.toml");
  std::unique_ptr<Editor> editor;
  std::string token;
  std::unique_ptr<httplib::Client> client;
};

TEST_F(Editors, ADocumentHasItsTextItsCurvesAndItsFindings) {
  const json document = get("/document");
  EXPECT_EQ(document["text"], feeder);
  EXPECT_EQ(document["saved"], true);
  EXPECT_EQ(document["undo"], nullptr);
  EXPECT_EQ(document["cam"]["segments"][0]["law"], "345");
  EXPECT_EQ(document["cam"]["knots"][1]["master"], 100);
  EXPECT_EQ(document["charts"].size(), 1U);
  EXPECT_NEAR(finding(document, "limit/geo_velocity")["value"], 1.875 * 50 / 100,
              1e-12);  // Cv 15/8
  EXPECT_THAT(document["check"], HasSubstr("feeder"));
}

TEST_F(Editors, AChangeIsCheckedAndHasItsPlaceInTheText) {
  const json document = change({{"do", "move"}, {"knot", 1}, {"master", 100}, {"slave", 60}});
  std::string expected = feeder;
  expected.replace(expected.find("slave = 50"), 10, "slave = 60");
  EXPECT_EQ(document["text"], expected);
  EXPECT_EQ(document["saved"], false);
  EXPECT_EQ(document["undo"], "move knot 1");
  EXPECT_EQ(document["result"]["ok"], false);
  EXPECT_NEAR(document["result"]["findings"][0]["value"], 1.125, 1e-12);
  EXPECT_EQ(document["result"]["findings"][0]["line"], 6);
  EXPECT_EQ(read_file(path), feeder) << "only /save writes the file";
}

TEST_F(Editors, APreviewChangesNothing) {
  const json before = get("/document");
  const json seen =
      post("/preview", {{"change", {{"do", "move"}, {"knot", 1}, {"master", 80}, {"slave", 50}}}});
  EXPECT_THAT(seen["text"], HasSubstr("master = 80"));
  EXPECT_EQ(seen["charts"].size(), 1U);
  EXPECT_EQ(get("/document"), before);
}

TEST_F(Editors, UndoRedoAndSave) {
  const json changed = change({{"do", "append"}});
  const json undone = post("/undo", {{"revision", changed["revision"]}});
  EXPECT_EQ(undone["text"], feeder);
  EXPECT_EQ(undone["redo"], "add a segment");
  const json redone = post("/redo", {{"revision", undone["revision"]}});
  EXPECT_EQ(redone["text"], changed["text"]);
  const json saved = post("/save", {{"revision", redone["revision"]}});
  EXPECT_EQ(saved["saved"], true);
  EXPECT_EQ(read_file(path), changed["text"]);
  EXPECT_TRUE(editor->is_saved());
}

TEST_F(Editors, ABrokenTextIsKeptWithItsErrors) {
  std::string broken = feeder;
  broken.replace(broken.find("master = 100"), 12, "master = no ");
  const json document =
      post("/document", {{"revision", get("/document")["revision"]}, {"text", broken}});
  EXPECT_EQ(document["text"], broken);
  EXPECT_TRUE(document["charts"].empty());
  EXPECT_EQ(document["cam"], nullptr);
  EXPECT_EQ(document["result"]["findings"][0]["line"], 8);
  EXPECT_EQ(change({{"do", "append"}}, 400)["ok"], false);
}

TEST_F(Editors, AKnotOutOfOrderStillHasItsTable) {
  const json document = change({{"do", "set"}, {"knot", 1}, {"key", "master"}, {"value", -5}});
  EXPECT_TRUE(document["charts"].empty());
  EXPECT_EQ(document["cam"]["knots"][1]["master"], -5);
  EXPECT_EQ(document["result"]["ok"], false);
}

TEST_F(Editors, TheSecondOfTwoPagesIsAskedToReadAgain) {
  const json both = get("/document");
  post("/document", {{"revision", both["revision"]}, {"text", feeder + "# one\n"}});
  const json answer =
      post("/document", {{"revision", both["revision"]}, {"text", feeder + "# two\n"}}, 409);
  EXPECT_THAT(answer["reason"], HasSubstr("the text has another revision by now"));
  EXPECT_EQ(get("/document")["text"], feeder + "# one\n");
}

TEST_F(Editors, AFileThatChangesOnTheDiskIsShown) {
  write_file(path, feeder + "# by another program\n");
  wait_for([&](const json& now) { return now["text"] == feeder + "# by another program\n"; });
}

TEST_F(Editors, AConflictIsShownAndResolved) {
  change({{"do", "append"}});
  write_file(path, feeder + "# other\n");
  const json conflict = wait_for([](const json& now) { return now["on_disk"] == "changed"; });
  EXPECT_EQ(conflict["file_text"], feeder + "# other\n");
  EXPECT_EQ(post("/save", {{"revision", conflict["revision"]}}, 409)["ok"], false);
  EXPECT_EQ(get("/difference")["before"], feeder + "# other\n");
  const json taken = post("/conflict", {{"revision", conflict["revision"]}, {"use", "file"}});
  EXPECT_EQ(taken["text"], feeder + "# other\n");
  EXPECT_EQ(post("/undo", {{"revision", taken["revision"]}})["text"], conflict["text"]);
}

TEST_F(Editors, ExportsTheTableAndTheReport) {
  const auto csv = client->Get("/table?form=csv", headers());
  EXPECT_THAT(csv->body, HasSubstr("quintic_hermite"));
  EXPECT_THAT(client->Get("/table", headers())->body, csv->body);
  EXPECT_THAT(client->Get("/table?form=codesys", headers())->body,
              Not(HasSubstr("quintic_hermite")));
  for (const char* query : {"form=../../etc/passwd", "form=csv&axis=1", "axis=-1", "axis=x"})
    EXPECT_EQ(get(std::string("/table?") + query, 400)["ok"], false) << query;
  EXPECT_THAT(client->Get("/report", headers())->body, HasSubstr("<title>feeder"));
  EXPECT_THAT(get("/forms"), testing::Contains(json("csv")));
  EXPECT_EQ(get("/laws").size(), all_laws().size());
}

/// A cam with [master] has a file in every form but that of a gear. The forms for motions over time
/// take it over time; controllers that count need the size of a count.
TEST_F(Editors, ExportsEveryForm) {
  post("/document", {{"revision", 1}, {"text", feeder + "[master]\nvelocity = 50\n"}});
  int written = 0;
  for (const json& each : get("/forms")) {
    const std::string form = each;
    if (form == "hmpl-gear") continue;
    std::string query;
    for (const char* options :
         {"", "&x_step=0.001&p_step=0.0001", "&over=time", "&over=time&p_step=0.0001",
          "&over=time&x_step=0.001&p_step=0.0001"}) {
      query = "form=" + form + "&tolerance=0.01" + options;
      if (client->Get("/table?" + query, headers())->status == 200) break;
    }
    const auto file = client->Get("/table?" + query, headers());
    EXPECT_EQ(file->status, 200) << query << file->body;
    const json conversion = get("/conversion?" + query);
    EXPECT_EQ(conversion["fits"], true) << form;
    EXPECT_THAT(conversion["ending"].get<std::string>(), testing::StartsWith(".")) << form;
    EXPECT_THAT(conversion["text"].get<std::string>(), HasSubstr("-> " + form)) << form;
    ++written;
  }
  EXPECT_GT(written, 25);
  const auto npy = client->Get("/table?form=npy", headers());
  EXPECT_EQ(npy->get_header_value("Content-Type"), "application/octet-stream");
  EXPECT_EQ(npy->body.substr(0, 6), "\x93NUMPY") << "the bytes of the file";
  EXPECT_EQ(get("/conversion?form=hmpl-gear")["fits"], false);
  EXPECT_THAT(get("/table?form=hmpl-gear", 400)["reason"], HasSubstr("exceeds the tolerance"));
  EXPECT_THAT(get("/table?form=galil", 400)["reason"], HasSubstr("x_step: is missing"));
  EXPECT_EQ(get("/table?over=x", 400)["ok"], false);
}

TEST_F(Editors, ComparesWithTheSavedFile) {
  change({{"do", "move"}, {"knot", 1}, {"master", 100}, {"slave", 60}});
  const json difference = get("/difference");
  EXPECT_EQ(difference["before"], feeder);
  EXPECT_THAT(difference["difference"], HasSubstr("differs by 10 mm at 100 deg"));
  EXPECT_EQ(difference["charts"][0]["views"][0]["curves"].size(), 2U);
}

const std::string free_knot = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic"
end = { master = 60, slave = 20 }
free = { slave = [10, 40], geo_velocity = [0, 2] }
[[segment]]
law = "quintic"
end = { master = 100, slave = 50 }
[optimize]
minimize = ["peak geo_acceleration"]
)";

TEST_F(Editors, OptimizesAndTakesTheResult) {
  EXPECT_EQ(get("/optimum", 404)["ok"], false);
  const json before =
      post("/document", {{"revision", get("/document")["revision"]}, {"text", free_knot}});
  EXPECT_EQ(before["can_optimize"], true);
  post("/optimize", json::object());
  const json optimum = ended("/optimum");
  ASSERT_TRUE(optimum["spec"].is_string()) << optimum.dump();
  EXPECT_EQ(optimum["charts"][0]["views"][0]["curves"].size(), 2U);
  const json taken = post("/optimum", {{"do", "take"}, {"revision", before["revision"]}});
  EXPECT_EQ(taken["text"], optimum["spec"]);
  EXPECT_EQ(taken["undo"], "optimize");
  EXPECT_EQ(get("/optimum", 404)["ok"], false);
}

TEST_F(Editors, AnOptimumOfAnotherTextIsNotTaken) {
  const json before =
      post("/document", {{"revision", get("/document")["revision"]}, {"text", free_knot}});
  post("/optimize", json::object());
  post("/optimum", {{"do", "stop"}});
  while (get("/optimum")["running"]) std::this_thread::sleep_for(50ms);
  const json changed =
      post("/document", {{"revision", before["revision"]}, {"text", free_knot + "# more\n"}});
  const json answer = post("/optimum", {{"do", "take"}, {"revision", changed["revision"]}}, 409);
  EXPECT_EQ(get("/document")["text"], free_knot + "# more\n") << answer.dump();
  post("/optimum", {{"do", "discard"}});
  EXPECT_EQ(get("/optimum", 404)["ok"], false);
}

/// The numbers of the proof are those of `jounce validate`.
TEST_F(Editors, ValidatesTheText) {
  EXPECT_EQ(get("/proof", 404)["ok"], false);
  EXPECT_EQ(post("/proof", {{"do", "stop"}}, 404)["ok"], false);
  post("/validate", json::object());
  const json proof = ended("/proof");
  EXPECT_EQ(proof["error"], "");
  EXPECT_EQ(proof["proven"], true);
  EXPECT_EQ(proof["current"], true);
  const Input input = read_inputs(path).front();
  EXPECT_EQ(proof["text"], proof_answer(prove(input), input));
  change({{"do", "append"}});
  EXPECT_EQ(get("/proof")["current"], false) << "the text has changed";
  post("/proof", {{"do", "discard"}});
  EXPECT_EQ(get("/proof", 404)["ok"], false);
  EXPECT_THAT(post("/proof", {{"do", "take"}}, 404)["reason"], HasSubstr("no validation"));
}

const std::string many_cases = R"(
[drive.tolerances]
method = "monte_carlo"
cases = 200000
[[drive.tolerances.number]]
key = "mass[1].inertia"
share = "20 %"
)";

TEST_F(Editors, AValidationIsStoppedAndReportsErrors) {
  const std::string move = read_file(JOUNCE_SOURCE_DIR "/examples/fastest-for-motor/move.toml");
  post("/document", {{"revision", get("/document")["revision"]}, {"text", move + many_cases}});
  post("/validate", json::object());
  json proof = get("/proof");
  for (int turn = 0; turn < 600 && proof["step"] != "tolerances"; ++turn) {
    std::this_thread::sleep_for(20ms);
    proof = get("/proof");
  }
  ASSERT_EQ(proof["running"], true) << proof;
  EXPECT_THAT(post("/validate", json::object(), 409)["reason"], HasSubstr("stop it first"));
  post("/proof", {{"do", "stop"}});
  proof = ended("/proof");
  EXPECT_EQ(proof["error"], "stopped: nothing is proven");
  EXPECT_EQ(proof["proven"], false);
  post("/document", {{"revision", get("/document")["revision"]}, {"text", "jounce = 1\nkind ="}});
  EXPECT_THAT(post("/validate", json::object(), 400)["reason"], HasSubstr("feeder.toml:2"));
}

TEST_F(Editors, ExportsEachAxis) {
  const std::string axes = read_file(JOUNCE_SOURCE_DIR "/cli/templates/axes.toml");
  const json document =
      post("/document", {{"revision", get("/document")["revision"]}, {"text", axes}});
  ASSERT_EQ(document["charts"].size(), 2U) << document["result"];
  const std::string first = client->Get("/table?axis=0", headers())->body;
  const std::string second = client->Get("/table?axis=1", headers())->body;
  EXPECT_THAT(first, HasSubstr("# jounce table 1"));
  EXPECT_THAT(second, HasSubstr("# jounce table 1"));
  EXPECT_NE(first, second);
  EXPECT_THAT(client->Get("/report?axis=1", headers())->body, HasSubstr("<title>"));
}

TEST_F(Editors, ComparesATextWithAnError) {
  post("/document",
       {{"revision", get("/document")["revision"]}, {"text", "jounce = 1\nkind = \n"}});
  const json difference = get("/difference");
  EXPECT_EQ(difference["before"], feeder);
  EXPECT_THAT(difference["difference"], HasSubstr("feeder.toml:2"));
  EXPECT_TRUE(difference["charts"].empty());
}

// ---- hostile requests ---------------------------------------------------------------------------

TEST_F(Editors, NothingIsReadOrChangedWithoutTheToken) {
  for (const char* target : {"/document", "/difference", "/table", "/conversion", "/report",
                             "/laws", "/forms", "/optimum", "/proof", "/stream", "/events"}) {
    EXPECT_EQ(client->Get(target)->status, 403) << target;
    EXPECT_EQ(client->Get(target, {{"X-Jounce-Token", "0123"}})->status, 403) << target;
  }
  for (const char* target :
       {"/document", "/change", "/preview", "/undo", "/redo", "/save", "/conflict", "/optimize",
        "/optimum", "/validate", "/proof", "/stream"})
    EXPECT_EQ(client->Post(target, "{}", "application/json")->status, 403) << target;
  const std::string page =
      client->Get("/")->body + client->Get("/edit.js")->body + client->Get("/edit.css")->body;
  EXPECT_THAT(page, Not(HasSubstr(token)));
  EXPECT_THAT(page, Not(HasSubstr("feeder")));
}

TEST_F(Editors, OtherOriginsAreRejected) {
  for (const auto& [key, value] : {std::pair{"Host", "evil.example"},
                                   {"Origin", "http://evil.example"},
                                   {"Sec-Fetch-Site", "cross-site"}}) {
    httplib::Headers with = headers();
    with.emplace(key, value);
    EXPECT_EQ(client->Get("/document", with)->status, 403) << key;
    EXPECT_EQ(client->Post("/save", with, R"({"revision":1})", "application/json")->status, 403)
        << key;
  }
}

TEST_F(Editors, ABodyHasALimit) {
  std::signal(SIGPIPE, SIG_IGN);  // the client writes to a connection that the server closes
  const auto answer =
      client->Post("/document", headers(), std::string(10'000'000, 'x'), "application/json");
  if (answer) {
    EXPECT_EQ(answer->status, 413);
  }  // or the connection is closed while it is sent
  EXPECT_EQ(get("/document")["text"], feeder);
}

TEST_F(Editors, OtherPathsDoNotExist) {
  for (const char* target : {"/../feeder.toml", "/feeder.toml", "/edit.js/../../feeder.toml",
                             "/%2e%2e/feeder.toml", "//document", "/document/"})
    EXPECT_EQ(client->Get(target, headers())->status, 404) << target;
}

TEST_F(Editors, BadBodiesAreRejectedWithAReason) {
  for (const char* body :
       {"", "no json", "[1]", "{}", R"({"revision":"1","text":""})", R"({"revision":1,"text":3})",
        R"({"revision":1,"text":"","more":1})", "{\"revision\":1,\"text\":\"\xff\"}"}) {
    const auto answer = client->Post("/document", headers(), body, "application/json");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 400) << body << answer->body;
    EXPECT_EQ(json::parse(answer->body)["ok"], false);
  }
  EXPECT_EQ(get("/document")["text"], feeder);
}

TEST_F(Editors, AFileHasOneEditor) {
  EXPECT_THAT(test::why([&] { Editor second(path, web::Listening(0)); }),
              HasSubstr("is open in another `jounce edit`"));
  editor.reset();
  EXPECT_NO_THROW(Editor(path, web::Listening(0)));
}

TEST_F(Editors, AFileThatIsNoSpecIsRejectedLikeByOtherVerbs) {
  const auto rejection = [&](const std::string& name, const std::string& text) {
    write_file(in(name.c_str()), text);
    return test::why([&] { Editor other(in(name.c_str()), web::Listening(0)); });
  };
  EXPECT_THAT(rejection("passwd", "root:x:0:0:root:/root:/bin/sh\n"),
              HasSubstr("is not a spec, a table, a G-code program or a controller file"));
  EXPECT_THAT(rejection("a.bin", std::string("\x7f"
                                             "ELF\0\0",
                                             6)),
              HasSubstr("zero byte"));
  EXPECT_THAT(rejection("a.csv", "X,Y\n0,0\n1,2\n"), Not(std::string()));
  EXPECT_THAT(rejection("other.toml", "hello = 3\n"), HasSubstr("a spec begins with"));
  EXPECT_EQ(rejection("broken.toml", "jounce = 1\nkind = \n"), "") << "the editor repairs it";
  EXPECT_EQ(rejection("empty.toml", "\n"), "");
}

TEST_F(Editors, ANewFileBeginsWithATemplate) {
  editor.reset();
  editor =
      std::make_unique<Editor>(in("new.toml"), web::Listening(0),
                               std::map<std::string, std::string>{{"cam", feeder}, {"bad", "x"}});
  const std::string address = editor->address();
  token = address.substr(address.find('#') + 1);
  client = std::make_unique<httplib::Client>(address.substr(0, address.find("/#")));
  json document = get("/document");
  EXPECT_EQ(document["text"], "");
  EXPECT_EQ(document["on_disk"], "missing");
  const json templates = get("/templates");
  ASSERT_EQ(templates.size(), 2U);
  EXPECT_EQ(templates[0]["picture"], "");
  EXPECT_THAT(templates[1]["picture"].get<std::string>(), HasSubstr("<svg"));
  document =
      post("/document", {{"revision", document["revision"]}, {"text", templates[1]["text"]}});
  EXPECT_EQ(document["charts"].size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(in("new.toml")));
  document = post("/save", {{"revision", document["revision"]}});
  EXPECT_EQ(document["saved"], true);
  EXPECT_EQ(read_file(in("new.toml")), feeder);
}

TEST_F(Editors, MeasuredPointsAreFitted) {
  const json fitted =
      post("/fit", {{"name", "points.csv"},
                    {"points", "master [deg],slave [mm]\n0,0\n25,6\n50,25\n75,44\n100,50\n"},
                    {"tolerance", "0.1"}});
  EXPECT_EQ(fitted["within"], true);
  EXPECT_THAT(fitted["spec"].get<std::string>(), HasSubstr("kind = \"cam\""));
  EXPECT_EQ(fitted["charts"].size(), 1U);
  EXPECT_EQ(get("/document")["text"], feeder) << "a fit changes nothing";
  post("/fit", {{"name", "points.csv"}, {"points", "no numbers"}, {"tolerance", "0.1"}}, 400);
}

TEST_F(Editors, TheNewestCommitIsCompared) {
  EXPECT_THAT(get("/difference?against=head", 400)["reason"].get<std::string>(),
              HasSubstr("is not in the newest commit"));
  const std::string git = "git -C '" + folder() + "' -c user.name=a -c user.email=a@b.c ";
  ASSERT_EQ(
      std::system(
          (git + "init -q && " + git + "add feeder.toml && " + git + "commit -q -m x").c_str()),
      0);
  change({{"do", "move"}, {"knot", 1}, {"master", 100}, {"slave", 60}});
  const json difference = get("/difference?against=head");
  EXPECT_EQ(difference["before"], feeder);
  EXPECT_THAT(difference["difference"].get<std::string>(), HasSubstr("60"));
  get("/difference?against=tail", 400);
}

TEST_F(Editors, OtherKindsHaveTheirCurves) {
  const std::string move =
      "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\nprofile = "
      "\"s_curve\"\nto "
      "= 50\nvelocity = 10\nacceleration = 20\njerk = 100\n";
  const json document =
      post("/document", {{"revision", get("/document")["revision"]}, {"text", move}});
  EXPECT_EQ(document["result"]["kind"], "move");
  EXPECT_EQ(document["charts"].size(), 1U);
  EXPECT_EQ(document["cam"], nullptr);
}

/// A stream of the feeder with a virtual master, to a bus of Unix sockets on which nothing answers.
TEST_F(Editors, NothingIsSentWithoutTheConfirmationOfAnOffer) {
  std::filesystem::create_directory(in("bus"));
  const std::string with_master = feeder + "[master]\nvelocity = 50\n";
  (void)post("/document", {{"revision", 1}, {"text", with_master}});
  const json wanted{{"do", "offer"}, {"axis", 0}, {"to", "feeder"}, {"url", "unix://" + in("bus")}};
  const json confirm_nothing{{"do", "confirm"}, {"confirmation", ""}};
  EXPECT_THAT(post("/stream", confirm_nothing, 409)["reason"], HasSubstr("make an offer first"));
  const json offer = post("/stream", wanted);
  EXPECT_EQ(offer["table"].get<std::string>().size(), 64U);
  EXPECT_EQ(offer["duration"], 2);  // 100 deg at 50 deg/s
  EXPECT_EQ(offer["axis"], nullptr) << "no executor answers";
  (void)get("/stream", 404);
  EXPECT_THAT(post("/stream", confirm_nothing, 409)["reason"], HasSubstr("make an offer first"));

  const auto confirm = [](const json& given) {
    return json{{"do", "confirm"}, {"confirmation", given["confirmation"]}};
  };
  (void)post("/document", {{"revision", 2}, {"text", with_master + "# later\n"}});
  EXPECT_THAT(post("/stream", confirm(offer), 409)["reason"],
              HasSubstr("the text has changed since the offer"));
  const json first = post("/stream", wanted);
  const json second = post("/stream", wanted);
  (void)post("/stream", confirm(first), 409);  // replaced by the second one
  (void)post("/stream", confirm(second));
  (void)post("/stream", confirm(second), 409);  // once only
  (void)post("/stream", {{"do", "cancel"}});
  const json state = ended("/stream");
  EXPECT_EQ(state["started"], false);
}

/// A cam on the live master of the axis, and a follow spec, which plays from two banks.
TEST_F(Editors, AnOfferWithALiveMaster) {
  std::filesystem::create_directory(in("bus"));
  json wanted{{"do", "offer"},
              {"axis", 0},
              {"to", "feeder"},
              {"url", "unix://" + in("bus")},
              {"live", true}};
  const json at_once = post("/stream", wanted);
  EXPECT_EQ(at_once["begin"], "at once");
  EXPECT_EQ(at_once["duration"], 100);
  EXPECT_EQ(at_once["time_unit"], "deg");
  wanted["start_at"] = 30;
  const json later = post("/stream", wanted);
  EXPECT_EQ(later["begin"], "when the master passes 30 deg");
  EXPECT_EQ(later["table"], at_once["table"]);
  wanted["live"] = false;
  EXPECT_THAT(post("/stream", wanted, 400)["reason"], HasSubstr("need a live master"));
  wanted["live"] = "yes";
  EXPECT_THAT(post("/stream", wanted, 400)["reason"], HasSubstr("must be true or false"));

  const std::string follow = read_file(JOUNCE_SOURCE_DIR "/cli/templates/follow.toml");
  post("/document", {{"revision", get("/document")["revision"]}, {"text", follow}});
  wanted.erase("start_at");
  wanted.erase("live");
  wanted["relative"] = true;
  const json banks = post("/stream", wanted);
  EXPECT_EQ(banks["table"], nullptr) << "rows have no hash";
  EXPECT_GT(banks["knots"], 2);
  wanted["live"] = true;
  EXPECT_THAT(post("/stream", wanted, 400)["reason"], HasSubstr("defines its own master"));
  (void)post("/stream", {{"do", "confirm"}, {"confirmation", banks["confirmation"]}});
  (void)post("/stream", {{"do", "cancel"}});
  EXPECT_EQ(ended("/stream")["started"], false) << "no executor answers";
}

TEST_F(Editors, AnOfferNamesWhatIsWrong) {
  const auto refused = [&](json wanted) {
    wanted["do"] = "offer";
    return post("/stream", wanted, 400)["reason"].get<std::string>();
  };
  EXPECT_THAT(refused({{"axis", 0}, {"to", "a b"}}), HasSubstr("to = a b"));
  EXPECT_THAT(refused({{"axis", 0}, {"to", "feeder"}}), HasSubstr("master"));
  (void)post("/document", {{"revision", 1}, {"text", feeder + "[master]\nvelocity = 50\n"}});
  EXPECT_THAT(refused({{"axis", 1}, {"to", "feeder"}}),
              HasSubstr("axis = 1: must be 0: the spec has one axis"));
  EXPECT_THAT(refused({{"axis", 0}, {"to", "feeder"}, {"url", "unix://" + in("none")}}),
              HasSubstr("names a folder that does not exist"));
  EXPECT_FALSE(std::filesystem::exists(in("none")));
  EXPECT_THAT(post("/stream", {{"do", "send"}}, 400)["reason"],
              HasSubstr("must be offer, confirm or cancel"));
}

}  // namespace
}  // namespace jounce::editor_test
