// Surfaces that were computed when the site was built: meshes, lines and dots as plain data, turned and lit here.

import { data, element, statusLine } from "./site.js";
import { html } from "./svg.js";
import { turning } from "./turning.js";

const say = statusLine(element("status"));
const choice = element("surfaces");
const listed = await data("surfaces");
choice.append(...listed.map(({ name, title }) => html("option", { value: name }, title)));

async function show(name) {
  const { caption } = listed.find((one) => one.name === name);
  element("caption").textContent = caption;
  try {
    const scenes = await data(`surfaces/${name}`);
    if (choice.value !== name) return; // another was chosen meanwhile
    turning(element("scenes"), scenes);
    document.body.dataset.surface = name;
    say("");
  } catch (problem) {
    say(problem.message, true);
  }
}

choice.onchange = () => {
  history.replaceState(null, "", `#${choice.value}`);
  show(choice.value);
};
const asked = location.hash.slice(1);
if (listed.some(({ name }) => name === asked)) choice.value = asked;
show(choice.value);
