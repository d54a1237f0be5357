// One library for a page: questions go to the worker, answers come back as promises.

export class Kernel {
  #worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
  #waiting = new Map();
  #next = 0;
  #channels = new Map();

  constructor(status) {
    this.#worker.onmessage = ({ data }) => {
      if (data.broken) return status?.(`The library could not be started: ${data.broken}`, true);
      if (data.steps) return status?.(data.step < data.steps ? `the library starts in this page: ${data.doing} … ${data.step + 1}/${data.steps}` : "");
      const { resolve, reject } = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if (data.error) reject(new Error(data.error));
      else resolve(data);
    };
  }

  // What the library answers: `{answer, milliseconds}`; an error is the library's own words.
  ask(question, data = {}) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#worker.postMessage({ id, question, data });
    });
  }

  // The same for what changes faster than it is answered: of the questions that wait, only the last one is asked.
  latest(question, data, show, complain) {
    this.stale(question);
    const channel = this.#channel(question);
    channel.next = { data, show, complain };
    if (!channel.busy) this.#drain(question, channel);
  }

  // Where the answer to a question is shown.
  shows(question, ...elements) {
    this.#channel(question).elements = elements;
  }

  // Something has changed: what is shown belongs to what was before, and so does an answer that is under way.
  stale(question) {
    const channel = this.#channel(question);
    channel.changes += 1;
    channel.next = null;
    for (const element of channel.elements) element.setAttribute("aria-busy", "true");
  }

  // What is shown belongs to what is there.
  current(question) {
    for (const element of this.#channel(question).elements) element.removeAttribute("aria-busy");
  }

  #channel(question) {
    if (!this.#channels.has(question)) this.#channels.set(question, { busy: false, next: null, changes: 0, elements: [] });
    return this.#channels.get(question);
  }

  async #drain(question, channel) {
    channel.busy = true;
    while (channel.next) {
      const { data, show, complain } = channel.next;
      const { changes } = channel;
      channel.next = null;
      try {
        const told = await this.ask(question, data);
        if (channel.changes === changes) show(told);
      } catch (problem) {
        if (channel.changes === changes) complain(problem);
      }
      if (channel.changes === changes) this.current(question);
    }
    channel.busy = false;
  }
}
