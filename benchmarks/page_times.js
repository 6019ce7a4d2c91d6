// What takes how long in a page of the laboratory, in milliseconds.
(() => {
  const pause = (time) => new Promise((done) => setTimeout(done, time));
  const painted = () =>
    new Promise((done) =>
      requestAnimationFrame(() => {
        const channel = new MessageChannel();
        channel.port1.onmessage = done;
        channel.port2.postMessage(0);
      }),
    );
  const until = async (condition, most = 5000) => {
    const began = performance.now();
    while (!condition()) {
      if (performance.now() - began > most) throw new Error("nothing happened");
      await pause(0);
    }
  };

  window.times = {
    /** From the beginning of the navigation to the first paint, and to the first motion. */
    async opening() {
      while (!window.chaplygin) await pause(5);
      await window.chaplygin.ready;
      await painted();
      const ready = performance.now();
      const first = () => performance.getEntriesByName("first-contentful-paint")[0];
      // on a busy machine it is written down later
      await until(first);
      return [first().startTime, ready];
    },

    /** From each move of the mass's slider until the new motion is painted. */
    async slider(count) {
      const slider = [...document.querySelectorAll("input[type=range]")].find((input) =>
        /mass/i.test(input.getAttribute("aria-label") ?? ""),
      );
      const { chaplygin } = window;
      chaplygin.seek(1);
      const first = Number(slider.value);
      const step = (Number(slider.max) - Number(slider.min)) / 400;
      const spent = [];
      for (let k = 1; k <= count; k++) {
        const before = JSON.stringify(chaplygin.pose());
        const began = performance.now();
        slider.value = String(first + step * (k % 2));
        slider.dispatchEvent(new Event("input", { bubbles: true }));
        await until(() => JSON.stringify(chaplygin.pose()) !== before);
        await painted();
        spent.push(performance.now() - began);
        slider.dispatchEvent(new Event("change", { bubbles: true }));
        await pause(500);
      }
      return spent;
    },

    /** From the next click into the section until its orbit has a thousand points; NaN if in 20 s it has not. */
    click() {
      const panel = document.querySelector(".lab-panel-section");
      const points = (orbit) => Number(orbit.getAttribute("aria-label").match(/(\d+) points/)[1]);
      const orbits = () => [...panel.querySelectorAll("[aria-label^='Play orbit']")];
      const whole = () => orbits().filter((orbit) => points(orbit) >= 1000).length;
      const before = whole();
      window.times.clicked = new Promise((done) => {
        const began = async () => {
          const from = performance.now();
          try {
            await until(() => whole() !== before, 2e4);
          } catch {
            return done(NaN);
          }
          await painted();
          done(performance.now() - from);
        };
        panel.addEventListener("pointerup", () => void began(), { capture: true, once: true });
      });
    },

    /** Frames per second, over some seconds. */
    async frames(seconds) {
      const began = performance.now();
      let count = 0;
      while (performance.now() - began < 1e3 * seconds) {
        await new Promise(requestAnimationFrame);
        count += 1;
      }
      return (1e3 * count) / (performance.now() - began);
    },
  };
})();
