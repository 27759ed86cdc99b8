"""The page that `tencer view` writes, driven in a browser as its readers do.

usage: page.py TENCER CHROMIUM CHROMEDRIVER FOLDER
"""
import json
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

import designs
from browser import Browser

ESCAPE = "\ue00c"
# Puts everything back as the page had it first; a page takes longer to load.
KEEP_FIRST = """
window.first = [...document.querySelectorAll('select, input')]
  .map((one) => [one, one.value, one.checked]);
"""
PUT_BACK = """
for (const [one, value, checked] of window.first) {
  if (one.checked !== checked) one.click();
  if (one.value === value) continue;
  one.value = value;
  for (const kind of ['input', 'change']) one.dispatchEvent(new Event(kind));
}
const lens = document.getElementById('lens');
if (lens.textContent === 'perspective') lens.click();
document.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }));
document.querySelector("[data-view='home']").click();
window.scrollTo(0, 0);
window.saved = [];
"""
NO_WEBGL = """
const get = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.includes('webgl') ? null : get.call(this, kind, ...more);
};
"""
# The ring fills nine tenths of the stage's height: its top, a place within it, and the paper.
TOP, WITHIN, PAPER = (0.5, 0.05 + 0.006), (0.5, 0.2), (0.02, 0.5)


def is_blue(colour):
    return colour[2] > colour[0] + 40


def distance(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


def run_tencer(*arguments):
    subprocess.run([tencer, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL)


# In the order of their names: those that share the page come before those "with" another.
class Page(unittest.TestCase):
    opened = None  # what the browser shows

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(chromium, driver)
        run_tencer("view", *designs.write(folder), "-o", "page.html")

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def open(self, page="page.html", width=800, height=600, **more):
        asked = page, width, height, more
        if Page.opened == asked:
            self.browser.run(PUT_BACK)
            self.browser.frame()
            return
        self.browser.open(folder / page, width, height, **more)
        self.browser.run(KEEP_FIRST)
        Page.opened = asked

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [])

    def face_on(self):
        self.browser.click("[data-view='front']")
        self.browser.click("#lens")
        for name in ("#show-target", "#show-labels"):
            self.browser.click(name)

    def test_head_says_what_is_so(self):
        self.open()
        facts = dict(zip(self.browser.texts("#facts dt"), self.browser.texts("#facts dd")))
        self.assertEqual(facts["cables"], "2")
        self.assertEqual(facts["largest error"], "4 mm (1.41 %)")
        self.assertEqual(facts["built with errors"], "cut to 1 mm, tied to 2 mm: within 2.1 mm (95 %)")
        self.assertEqual(facts["let go at the target"], "it settles here")
        self.assertIn("of 5 % held for long", facts["largest strain"])
        self.assertEqual(facts["section"], "circle r 3 mm")
        self.assertRegex(facts["weight"], r"^3\d\.?\d* g$")
        # What is not wholly checked is not green.
        self.assertEqual(self.browser.run("return document.getElementById('status').className"), "")
        self.assertEqual(self.browser.texts("#facts .good"), [])
        self.browser.choose("#design", "2")
        status = self.browser.texts("#status")[0]
        self.assertIn("comes to rest elsewhere", status)
        self.assertIn("too little", status)
        self.assertEqual(self.browser.run("return document.getElementById('status').className"), "bad")
        self.assertEqual(len(self.browser.texts("#facts .bad")), 2)

    def test_rods_are_where_they_belong_and_take_the_colour_asked_for(self):
        self.open()
        self.face_on()
        top, within, paper = self.browser.colours(TOP, WITHIN, PAPER)
        self.assertTrue(is_blue(top), top)
        self.assertLess(distance(within, paper), 8)
        self.browser.choose("#colour", "deviation")  # none at the top, all of it on the x axis
        least, = self.browser.colours(TOP)
        ring = self.browser.run("const { width, height } = document.querySelector('#stage canvas')"
                                ".getBoundingClientRect(); return 0.45 * 1.04 * height / width")
        most, = self.browser.colours((0.5 - ring + 0.003, 0.51))
        self.assertGreater(most[0], 150, most)  # yellow
        self.assertLess(most[2], 110, most)
        self.assertGreater(distance(least, most), 100)
        self.assertIn("4 mm", self.browser.texts("#legends")[0])

    def test_cables_are_chosen_in_the_drawing_and_in_the_list(self):
        self.open()
        self.face_on()
        box = self.browser.run("const box = document.getElementById('stage').getBoundingClientRect();"
                               "return [box.width, box.height]")
        self.browser.click_at("#stage canvas", box[0] * 0.53, box[1] / 2)
        self.assertEqual(self.browser.texts("#cables tr.chosen td:first-child"), ["1"])
        self.browser.press(ESCAPE)
        self.assertEqual(self.browser.texts("#cables tr.chosen"), [])
        self.browser.press("\ue007", "#cables tbody tr:nth-child(2)")
        self.assertEqual(self.browser.texts("#cables tr.chosen td:first-child"), ["2"])
        self.browser.click("#show-labels")
        self.browser.frame()
        self.assertEqual(self.browser.texts("#labels .chosen"), ["2"])
        self.browser.click("#closest tbody tr")
        self.assertEqual(len(self.browser.texts("#closest tr.chosen")), 1)

    def test_with_a_crossing_it_is_listed_and_shown(self):
        (folder / "eight.json").write_text(json.dumps(designs.eight("eight")))
        run_tencer("view", "eight.json", "-o", "eight.html")
        self.open("eight.html")
        over, under, apart = self.browser.texts("#crossing tbody td")
        self.assertEqual(apart, "20 mm")
        half = designs.length_of(designs.eight("eight")) / 2
        self.assertAlmostEqual(abs(float(over.split()[0]) - float(under.split()[0])), half, delta=0.1)
        self.face_on()
        middle = (0.5, 0.51)
        before, = self.browser.colours(middle)
        self.browser.click("#crossing tbody tr")
        after, = self.browser.colours(middle)
        self.assertEqual(len(self.browser.texts("#crossing tr.chosen")), 1)
        self.assertGreater(distance(before, after), 60)
        self.assertGreater(after[0], after[2] + 60)  # orange

    def test_a_point_of_the_plot_shows_its_design(self):
        self.open()
        x, y = self.browser.run("const point = Chart.getChart('trade-off').getDatasetMeta(0).data[1];"
                                "return [point.x, point.y]")
        self.browser.click_at("#trade-off", x, y)
        self.assertEqual(self.browser.texts("#facts dd")[0], "3")
        self.assertEqual(len(self.browser.texts("#cables tbody tr")), 3)
        self.browser.click("#designs-table tbody tr:last-child")
        self.assertEqual(self.browser.texts("#facts dd")[0], "5")
        self.face_on()
        self.browser.slide("#number", 0)
        self.assertEqual(self.browser.texts("#facts dd")[0], "2")
        across = [(x / 40, y / 40) for x in range(10, 31) for y in range(12, 30)]
        few = self.browser.colours(*across)
        self.browser.slide("#number", 2)
        self.assertEqual(self.browser.texts("#facts dd")[0], "5")
        self.assertNotEqual(self.browser.colours(*across), few)
        before, = self.browser.colours(TOP)
        self.browser.choose("#over", "0")
        after, = self.browser.colours(TOP)
        self.assertGreater(distance(before, after), 10)

    def test_units_and_files(self):
        self.open()
        self.assertEqual(self.browser.texts("#cables td:nth-child(2)")[0], "20.80")
        self.browser.choose("#unit", "in")
        self.assertEqual(self.browser.texts("#cables td:nth-child(2)")[0], "8.189")
        self.assertIn(" in", self.browser.texts("#scale-text")[0])
        self.browser.click("#save-list")
        text = self.browser.saved_text()
        self.assertTrue(text.startswith("design,cable,length in,from,to,tension N,note\nring,1,8.189,"),
                        text)
        self.browser.click("#save-marks")
        lines = self.browser.saved_text().splitlines()
        self.assertEqual(lines[0], "design,rod,s in,cable,goes to")
        self.assertEqual(len(lines), 5)

    def at_second(self, second, *places):
        """The colours there when the page plays."""
        self.browser.tick(second)
        return self.browser.colours(*places)

    def test_vibrations_and_shoves_are_played(self):
        self.open()
        self.face_on()
        above = [(0.5, y / 200) for y in range(4, 30)]
        still = self.browser.colours(*above)
        self.browser.hold()
        self.browser.choose("#mode", "0")
        self.assertNotEqual(self.at_second(0.6, *above), self.at_second(1.8, *above))
        names = self.browser.texts("#mode option")
        shove = next(i for i, name in enumerate(names) if name.startswith("smooth shove of 14.1 mm"))
        self.browser.choose("#mode", str(shove - 1))
        self.assertEqual(self.at_second(0, *above), still)
        self.assertNotEqual(self.at_second(0.7, *above), still)
        self.browser.let_go()
        self.browser.press(ESCAPE)
        self.assertEqual(self.browser.run("return document.getElementById('mode').value"), "-1")
        self.assertEqual(self.browser.colours(*above), still)

    def test_the_slider_goes_through_the_stages_of_the_search(self):
        self.open()
        self.face_on()
        self.assertEqual(self.browser.texts("#stages-label"), ["the design: 2 cables, off by 4 mm (1.41 %)"])
        upper, top = (0.5, 0.4), TOP
        paper, _ = self.browser.colours(upper, top)
        self.browser.slide("#stages-number", 0)
        self.assertEqual(self.browser.texts("#stages-label"), ["balance: 3 cables, off by 2.83 mm (1 %)"])
        cable, rod = self.browser.colours(upper, top)
        self.assertGreater(distance(cable, paper), 60)
        self.assertTrue(is_blue(rod))
        self.browser.slide("#stages-number", 1)
        self.assertEqual(self.browser.texts("#stages-label"),
                         ["elimination: 2 cables, off by 5.66 mm (2 %)"])
        cable, rod = self.browser.colours(upper, top)
        self.assertLess(distance(cable, paper), 8)
        self.assertFalse(is_blue(rod))  # it has moved
        self.browser.press(ESCAPE)
        self.assertIn("the design", self.browser.texts("#stages-label")[0])
        self.assertTrue(is_blue(self.browser.colours(top)[0]))

    def test_with_pulled_cables_the_slider_goes_through_their_poses(self):
        (folder / "bow.json").write_text(json.dumps(designs.bow("bow")))
        (folder / "pull.toml").write_text('[[step]]\n1 = "by -30 %"\nframes = 4\n')
        run_tencer("simulate", "bow.json", "-o", "rest")
        run_tencer("actuate", "rest/design.json", "pull.toml", "-o", "moves")
        self.open("moves/view.html")
        self.face_on()
        last = int(self.browser.run("return document.getElementById('poses-number').max"))
        self.assertGreaterEqual(last, 4)
        self.assertFalse(self.browser.shown("#stages"))
        places = [(x / 40, y / 40) for x in range(2, 39) for y in range(2, 39)]
        open_bow = self.browser.colours(*places)
        labels = self.browser.texts("#poses-label")
        self.browser.slide("#poses-number", last)
        labels += self.browser.texts("#poses-label")
        self.assertEqual(labels[1], "step 1, 100 %")
        self.assertNotEqual(labels[0], labels[1])
        self.assertNotEqual(self.browser.colours(*places), open_bow)
        self.browser.slide("#poses-number", 0)
        self.assertEqual(self.browser.colours(*places), open_bow)
        self.browser.hold()
        self.browser.click("#poses-play")
        for second in (0, 1):
            self.browser.tick(second)
        self.assertEqual(self.browser.run("return document.getElementById('poses-number').value"), "1")
        self.browser.let_go()

    def test_keys_and_labels(self):
        self.open()
        self.browser.press("o", "#stage canvas")
        self.assertEqual(self.browser.texts("#lens"), ["perspective"])
        self.browser.choose("#design", "2")
        overlaps = self.browser.run("""
          const boxes = [...document.querySelectorAll('#labels span')]
            .filter((one) => one.style.visibility === 'visible')
            .map((one) => one.getBoundingClientRect());
          return [boxes.length, boxes.filter((a, i) => boxes.some((b, j) => i < j &&
            a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)).length];
        """)
        self.assertGreater(overlaps[0], 3)
        self.assertEqual(overlaps[1], 0)

    def test_the_view_turns_and_zooms_within_limits(self):
        self.open()
        start = self.browser.texts("#scale-text")[0]
        axis = "return document.getElementById('axis-x').getAttribute('x2')"
        home = self.browser.run(axis)
        self.browser.drag("#stage canvas", 200, 200, 120, 0)
        self.browser.wait(f"{axis} !== arguments[0]", home)
        for turn, least, most in (-400, 0.05, 0.5), (400, 10, 50):
            self.browser.wheel("#stage canvas", turn, 100)
            length = float(self.browser.texts("#scale-text")[0].split()[0])
            self.assertTrue(least <= length <= most, length)
        self.browser.click("[data-view='home']")
        self.assertEqual(self.browser.texts("#scale-text")[0], start)
        self.assertEqual(self.browser.run(axis), home)

    def test_with_a_finger_on_a_phone_no_column_is_off_the_screen(self):
        self.open(width=390, height=844, touch=True)
        self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 390)
        self.assertTrue(self.browser.shown("#stage canvas"))
        self.assertLess(self.browser.run("return document.getElementById('stage').clientHeight"), 600)
        self.assertIn("finger", self.browser.texts("#hint")[0])
        self.browser.run("document.getElementById('stage').scrollIntoView()")
        scrolled = "return window.scrollY"
        axis = "return document.getElementById('axis-x').getAttribute('x2')"
        before = self.browser.run(scrolled), self.browser.run(axis)
        self.browser.swipe(200, 400, 0, -150)
        self.browser.wait(f"{scrolled} > arguments[0]", before[0])
        self.assertEqual(self.browser.run(axis), before[1])
        # A swipe goes on for a while after the finger has left.
        still = None
        while still != (still := self.browser.run(scrolled)):
            time.sleep(0.3)
        before = still, self.browser.run(axis)
        self.browser.swipe(100, 200, 120, 0)
        # The view follows when it is next drawn, which takes long on a busy machine.
        self.browser.wait(f"{axis} !== arguments[0]", before[1])
        self.assertEqual(self.browser.run(scrolled), before[0])

    def test_with_ink_there_are_the_view_and_the_lists(self):
        self.open(dark=True)
        self.browser.run("window.dispatchEvent(new Event('beforeprint'))")
        self.browser.media("print")
        self.browser.wait("return document.getElementById('printed').naturalWidth > 0")
        self.assertTrue(self.browser.shown("#printed"))
        self.assertTrue(self.browser.shown("#cables"))
        for name in ("#stage", "#save-png", "#save-list"):
            self.assertFalse(self.browser.shown(name), name)

    def test_without_webgl_there_is_the_picture(self):
        self.open(before=NO_WEBGL)
        self.assertTrue(self.browser.shown("#picture svg"))
        self.assertFalse(self.browser.shown("#stage"))
        self.assertEqual(len(self.browser.texts("#cables tbody tr")), 2)
        self.browser.complaints()  # three.js says that there is no WebGL


tencer, chromium, driver = sys.argv[1:4]
folder = pathlib.Path(sys.argv[4])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
unittest.main(argv=sys.argv[:1], verbosity=2)
