-- One run of the trainer: the file run.db in the run's folder. SI units. PRAGMA user_version holds
-- the version of this schema, PRAGMA application_id marks the file as ours (run_database.cpp).
-- All of this is repeated when a run is resumed, so that an older run gets the tables that were
-- added since.

-- What the run is: robot, robot_description, agent, profile, seed, episodes_planned, record_every,
-- checkpoint_seconds, version, started_at, finished_at, state (running, interrupted or finished),
-- body (body_json.h), settings and call (run_settings.h).
CREATE TABLE IF NOT EXISTS run (
  key TEXT PRIMARY KEY,
  value TEXT NOT NULL
);

-- The plugins that were loaded, in the order of loading: 1 is the task that the run began with.
CREATE TABLE IF NOT EXISTS task (
  id INTEGER PRIMARY KEY,
  module TEXT NOT NULL,     -- name of the task module
  name TEXT NOT NULL,
  file TEXT NOT NULL,
  hash TEXT NOT NULL,       -- SHA-256 of the sources
  plugin TEXT NOT NULL,     -- file name of the shared object in the run's folder
  compiler TEXT NOT NULL
);

-- The texts that a task is made of: its own first, then those it imports and extends.
CREATE TABLE IF NOT EXISTS source (
  task INTEGER NOT NULL REFERENCES task,
  id INTEGER NOT NULL,
  file TEXT NOT NULL,
  text TEXT NOT NULL,
  PRIMARY KEY (task, id)
) WITHOUT ROWID;

-- The named parts of a task's reward, in the order of its plugin.
CREATE TABLE IF NOT EXISTS term (
  task INTEGER NOT NULL REFERENCES task,
  id INTEGER NOT NULL,
  name TEXT NOT NULL,
  doc TEXT NOT NULL,
  PRIMARY KEY (task, id)
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS metric (
  task INTEGER NOT NULL REFERENCES task,
  id INTEGER NOT NULL,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  reduction TEXT NOT NULL,  -- last, sum, max, min or mean
  doc TEXT NOT NULL,
  PRIMARY KEY (task, id)
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS log (
  task INTEGER NOT NULL REFERENCES task,
  id INTEGER NOT NULL,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  reduction TEXT NOT NULL,  -- last, sum, max, min or mean
  doc TEXT NOT NULL,
  PRIMARY KEY (task, id)
) WITHOUT ROWID;

-- Numbered from 1.
CREATE TABLE IF NOT EXISTS episode (
  number INTEGER PRIMARY KEY,
  steps INTEGER NOT NULL,   -- time steps
  actions INTEGER NOT NULL,
  simulated_seconds REAL NOT NULL,
  wall_seconds REAL NOT NULL, -- that the run has waited for it
  cpu_seconds REAL NOT NULL   -- of the threads that ran it and learned from it
);

-- How each task that was loaded at the episode's end evaluates it. A value that is not a number is
-- NULL.
CREATE TABLE IF NOT EXISTS evaluation (
  episode INTEGER NOT NULL REFERENCES episode ON DELETE CASCADE,
  task INTEGER NOT NULL REFERENCES task,
  is_active INTEGER NOT NULL,  -- 1: its reward reached the learner; 0: a shadow
  return REAL,
  end_kind TEXT NOT NULL,      -- success, failure, truncated or diverged
  end_reason TEXT NOT NULL,
  faults INTEGER NOT NULL,     -- rewards not paid and actions not learned from, since they were,
                               -- or would have been, not finite or beyond 1e30
  violations INTEGER NOT NULL, -- callbacks in which something that the task requires did not hold
  PRIMARY KEY (episode, task)
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS evaluation_term (
  episode INTEGER NOT NULL,
  task INTEGER NOT NULL,
  id INTEGER NOT NULL,         -- of the task's term
  sum REAL,
  PRIMARY KEY (episode, task, id),
  FOREIGN KEY (episode, task) REFERENCES evaluation ON DELETE CASCADE
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS evaluation_metric (
  episode INTEGER NOT NULL,
  task INTEGER NOT NULL,
  id INTEGER NOT NULL,         -- of the task's metric
  value REAL,
  PRIMARY KEY (episode, task, id),
  FOREIGN KEY (episode, task) REFERENCES evaluation ON DELETE CASCADE
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS evaluation_log (
  episode INTEGER NOT NULL,
  task INTEGER NOT NULL,
  id INTEGER NOT NULL,         -- of the task's log
  value REAL,                  -- NULL where nothing was logged
  PRIMARY KEY (episode, task, id),
  FOREIGN KEY (episode, task) REFERENCES evaluation ON DELETE CASCADE
) WITHOUT ROWID;

-- The goals of each task, and what they were told in each episode. A run that was last trained by an
-- older version has neither of the two tables.
CREATE TABLE IF NOT EXISTS goal (
  task INTEGER NOT NULL REFERENCES task,
  id INTEGER NOT NULL,         -- from 0, as in the task
  name TEXT NOT NULL,
  type TEXT NOT NULL,          -- vec2, int, ...
  unit TEXT NOT NULL,
  doc TEXT NOT NULL,
  PRIMARY KEY (task, id)
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS evaluation_goal (
  episode INTEGER NOT NULL,
  task INTEGER NOT NULL,
  number INTEGER NOT NULL,     -- from 0, in the order of time
  goal INTEGER NOT NULL,       -- of the task
  time REAL NOT NULL,          -- [s] since the start of the episode
  value TEXT NOT NULL,         -- JSON: a list of numbers, SI units
  PRIMARY KEY (episode, task, number),
  FOREIGN KEY (episode, task) REFERENCES evaluation ON DELETE CASCADE
) WITHOUT ROWID;

-- The phases of each task, and what each was in each episode. A run that was last trained by an older
-- version has neither of the two tables.
CREATE TABLE IF NOT EXISTS phase (
  task INTEGER NOT NULL REFERENCES task,
  id INTEGER NOT NULL,         -- from 0, as in the task
  name TEXT NOT NULL,
  doc TEXT NOT NULL,
  PRIMARY KEY (task, id)
) WITHOUT ROWID;

CREATE TABLE IF NOT EXISTS evaluation_phase (
  episode INTEGER NOT NULL,
  task INTEGER NOT NULL,
  phase INTEGER NOT NULL,      -- of the task
  time REAL NOT NULL,          -- [s] that it has lasted, in all its passes
  return REAL NOT NULL,        -- what was paid in it
  PRIMARY KEY (episode, task, phase),
  FOREIGN KEY (episode, task) REFERENCES evaluation ON DELETE CASCADE
) WITHOUT ROWID;

-- What the learner reports for each episode, such as its learning rate. A run that was last trained by
-- an older version has neither of the two tables.
CREATE TABLE IF NOT EXISTS learner_curve (
  id INTEGER PRIMARY KEY,      -- in the order in which it shows them
  name TEXT NOT NULL UNIQUE,
  unit TEXT NOT NULL,
  doc TEXT NOT NULL
);

CREATE TABLE IF NOT EXISTS learner_value (
  episode INTEGER NOT NULL REFERENCES episode ON DELETE CASCADE,
  curve INTEGER NOT NULL REFERENCES learner_curve,
  value REAL,                  -- NULL where there was none
  PRIMARY KEY (episode, curve)
) WITHOUT ROWID;

-- What clients did to the run, by episode, step and id in the order in which it took effect: the
-- journal that is replayed when the run continues from a checkpoint. Stays when episodes are deleted
-- for that. A change that takes effect later when it is repeated is moved there, with another id.
CREATE TABLE IF NOT EXISTS change (
  id INTEGER PRIMARY KEY,
  episode INTEGER NOT NULL,    -- in which it took effect; the next one, if between two episodes
  step INTEGER NOT NULL,       -- time steps done in that episode before it
  at TEXT NOT NULL,            -- ISO 8601
  kind TEXT NOT NULL,          -- swap, set, ...
  text TEXT NOT NULL,          -- for a person
  data TEXT NOT NULL           -- JSON: the request with all that is needed to repeat it
);

-- On which machine the run was trained: from `episode` on, up to that of the next row. A run that was
-- last trained by an older version has no such table.
CREATE TABLE IF NOT EXISTS machine (
  episode INTEGER PRIMARY KEY,
  facts TEXT NOT NULL          -- JSON (machine.h)
);

-- `poses`: zstd of little-endian float32 [frames][poses][7]: x y z qw qx qy qz of the frame
-- of each link, and then of each of the world's things, at its center, world frame.
CREATE TABLE IF NOT EXISTS recording (
  episode INTEGER PRIMARY KEY REFERENCES episode ON DELETE CASCADE,
  is_best INTEGER NOT NULL,       -- 1: the highest return up to then
  frames INTEGER NOT NULL,
  frame_interval REAL NOT NULL,
  poses BLOB NOT NULL
);

-- What a recorded episode paid, measured and touched (timeline.h). An episode in which another task
-- took the place of the active one has none, nor has one that an older version recorded. `samples`:
-- zstd of the time at which the episode was over [s], a little-endian float64, and then, for each
-- frame of the recording and for the end of the episode, little-endian float32 values: columns of
-- what was paid since the value before, in all and for each term of the active task, of its metrics,
-- and, where it has phases, of the present one's number; then a bit for each pose (0 for a thing), in whole bytes,
-- whether it touched something.
CREATE TABLE IF NOT EXISTS timeline (
  episode INTEGER PRIMARY KEY REFERENCES recording ON DELETE CASCADE,
  samples BLOB NOT NULL
);

-- What a recorded episode was driven by, so that it can be simulated again (tape.h): zstd of how it
-- began, when actions started, and the joint targets in each time step. An episode of more than two
-- minutes has none, nor one that has diverged, nor one that an older version recorded.
CREATE TABLE IF NOT EXISTS tape (
  episode INTEGER PRIMARY KEY REFERENCES recording ON DELETE CASCADE,
  data BLOB NOT NULL
);

-- Everything needed to continue after `episode`: a hash of the rest (sealed_state.h), then zstd of the
-- modules' state (checkpoint.h).
CREATE TABLE IF NOT EXISTS checkpoint (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  episode INTEGER NOT NULL,
  state BLOB NOT NULL
);
