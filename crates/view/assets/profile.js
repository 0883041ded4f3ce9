"use strict";
{
  const { frame: [left, right, top, bottom], names, samples } = JSON.parse(document.getElementById("data").textContent);
  const svg = document.querySelector("#picture > svg");
  const scrub = document.getElementById("scrub");
  const [slider, output] = scrub.children;
  const last = samples.length - 1;
  const draw = (name, attributes) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return svg.appendChild(element);
  };
  const cross = draw("line", { class: "cross", y1: top, y2: bottom, visibility: "hidden" });
  const dots = names.map(() => draw("circle", { class: "dot", r: 3.2, visibility: "hidden" }));
  const said = ["time", ...names.map(([name]) => name)].map((name, i) => {
    const span = output.appendChild(document.createElement("span"));
    const value = document.createElement("b");
    span.append(name, value);
    return [value, i ? names[i - 1][1] : "s"];
  });
  const show = (index) => {
    const sample = samples[index];
    const x = left + (right - left) * index / last;
    for (const end of ["x1", "x2"]) cross.setAttribute(end, x);
    cross.setAttribute("visibility", "visible");
    dots.forEach((dot, i) => {
      dot.setAttribute("cx", x);
      dot.setAttribute("cy", sample[5 + i] ?? 0);
      dot.setAttribute("visibility", sample[1 + i] === null ? "hidden" : "visible");
    });
    said.forEach(([element, unit], i) => {
      const text = sample[i] === null ? "unbounded" : `${sample[i]} ${unit}`;
      element.textContent = text.replace("-", "−");
    });
    slider.value = index;
  };
  svg.addEventListener("pointermove", (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    show(Math.round(last * Math.min(1, Math.max(0, (at.x - left) / (right - left)))));
  });
  slider.addEventListener("input", () => show(Number(slider.value)));
  slider.max = last;
  scrub.hidden = false;
  show(0);
}
