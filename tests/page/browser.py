"""Chromium without a screen, and what a page in it shows."""
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

# Keeps what the page saves, in place of the dialogue of a browser; and a test may hold the page's
# frames and tell them the time, one after the other. Smooth edges would cost most of the time.
KEEP_SAVED = """
const context = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, more) {
  return context.call(this, kind, { ...more, antialias: false });
};
const soon = requestAnimationFrame;
let held = null;
window.requestAnimationFrame = (act) => held ? held.push(act) : soon(act);
window.frames = { soon, hold() { held = []; }, letGo() { held.forEach(soon); held = null; },
  tick(seconds) { const now = held; held = []; now.forEach((act) => act(1000 * seconds)); } };
window.saved = [];
const made = new Map();
const make = URL.createObjectURL;
URL.createObjectURL = (blob) => { const url = make(blob); made.set(url, blob); return url; };
HTMLAnchorElement.prototype.click = function () {
  window.saved.push({ name: this.download, blob: made.get(this.href) });
};
"""

# The colours at places of the last picture saved, given as parts of its width and height.
COLOURS = """
const [places, done] = arguments;
createImageBitmap(window.saved.at(-1).blob).then((image) => {
  const canvas = new OffscreenCanvas(image.width, image.height);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  done(places.map(([x, y]) => [...context.getImageData(
    Math.round(x * (image.width - 1)), Math.round(y * (image.height - 1)), 1, 1).data].slice(0, 3)));
});
"""


class Browser:
    def __init__(self, chromium, driver):
        options = Options()
        options.binary_location = chromium
        for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                         "--use-gl=angle", "--use-angle=swiftshader",
                         "--enable-unsafe-swiftshader"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(driver))
        self.scripts = []

    def open(self, page, width, height, before=KEEP_SAVED, dark=False, touch=False):
        """`before`: a script that runs before those of the page."""
        for script in self.scripts:
            self.command("Page.removeScriptToEvaluateOnNewDocument", identifier=script)
        self.scripts = [self.command("Page.addScriptToEvaluateOnNewDocument",
                                     source=before)["identifier"]]
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height,
                     deviceScaleFactor=1, mobile=touch)
        self.command("Emulation.setTouchEmulationEnabled", enabled=touch)
        self.media(dark=dark)
        self.driver.get(page.as_uri())
        self.frame()

    def command(self, name, **arguments):
        return self.driver.execute_cdp_cmd(name, arguments)

    def media(self, kind="screen", dark=False):
        self.command("Emulation.setEmulatedMedia", media=kind, features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def frame(self):
        """Waits until what was asked for is drawn."""
        self.driver.execute_async_script(
            "const soon = window.frames.soon ?? requestAnimationFrame;"
            "soon(() => soon(() => arguments[0]()))")

    def hold(self):
        self.run("window.frames.hold()")

    def tick(self, seconds):
        self.run("window.frames.tick(arguments[0])", seconds)

    def let_go(self):
        self.run("window.frames.letGo()")
        self.frame()

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def texts(self, selector):
        return self.run("return [...document.querySelectorAll(arguments[0])]"
                        ".map((one) => one.textContent)", selector)

    def shown(self, selector):
        return self.run("const one = document.querySelector(arguments[0]);"
                        "return one !== null && one.getClientRects().length > 0", selector)

    def choose(self, selector, value):
        self.run("const select = document.querySelector(arguments[0]);"
                 "select.value = arguments[1]; select.dispatchEvent(new Event('change'))",
                 selector, value)
        self.frame()

    def slide(self, selector, value):
        self.run("const slider = document.querySelector(arguments[0]);"
                 "slider.value = arguments[1]; slider.dispatchEvent(new Event('input'))",
                 selector, value)
        self.frame()

    def click(self, selector):
        self.run("document.querySelector(arguments[0]).click()", selector)
        self.frame()

    def press(self, key, selector="body"):
        self.find(selector).send_keys(key)
        self.frame()

    def place(self, selector, x, y):
        """On the screen, of a place in the element given in pixels."""
        self.run("document.querySelector(arguments[0]).scrollIntoView({ block: 'center' })", selector)
        left, top = self.run("const box = document.querySelector(arguments[0]).getBoundingClientRect();"
                             "return [box.left, box.top]", selector)
        return {"x": left + x, "y": top + y}

    def mouse(self, kind, place, **more):
        self.command("Input.dispatchMouseEvent", type=kind, **place, **more)

    def click_at(self, selector, x, y):
        self.drag(selector, x, y, 0, 0)

    def drag(self, selector, x, y, aside, down):
        place = self.place(selector, x, y)
        pressed = {"button": "left", "clickCount": 1}
        self.mouse("mouseMoved", place)
        self.mouse("mousePressed", place, **pressed)
        if aside or down:
            place = {"x": place["x"] + aside, "y": place["y"] + down}
            self.mouse("mouseMoved", place, buttons=1, **pressed)
        self.mouse("mouseReleased", place, **pressed)
        self.frame()

    def wheel(self, selector, down, times):
        self.run("""
          const [selector, deltaY, times] = arguments;
          for (let i = 0; i < times; ++i) document.querySelector(selector).dispatchEvent(
            new WheelEvent('wheel', { deltaY, bubbles: true, cancelable: true }));
        """, selector, down, times)
        self.frame()

    def swipe(self, x, y, aside, down):
        """With one finger, from a place on the screen."""
        steps = 10
        self.command("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        for step in range(1, steps + 1):
            self.command("Input.dispatchTouchEvent", type="touchMove", touchPoints=[
                {"x": x + aside * step / steps, "y": y + down * step / steps}])
        self.command("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.frame()

    def colours(self, *places):
        """Of the view at places given as parts of its width and height."""
        self.run("window.saved = []")
        self.click("#save-png")
        self.wait("return window.saved.length > 0")
        return self.driver.execute_async_script(COLOURS, [list(place) for place in places])

    def saved_text(self):
        return self.driver.execute_async_script(
            "window.saved.at(-1).blob.text().then(arguments[0])")

    def wait(self, script, *arguments):
        for _ in range(200):
            if self.run(script, *arguments):
                return
            self.frame()
        raise AssertionError(f"never so: {script}")

    def complaints(self):
        return [f"{line['level']}: {line['message']}" for line in self.driver.get_log("browser")]

    def close(self):
        self.driver.quit()
