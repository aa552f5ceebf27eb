-- One run of the trainer: the file run.db in the run's folder. SI units. PRAGMA user_version holds
-- the version of this schema, PRAGMA application_id marks the file as ours (run_database.cpp).

-- What the run is: task, task_file, task_hash, robot, robot_description, agent,
-- profile, seed, episodes_planned, record_every, checkpoint_seconds, plugin, version, compiler,
-- started_at, finished_at, state (running, interrupted or finished), body (body_json.h).
CREATE TABLE run (
  key TEXT PRIMARY KEY,
  value TEXT NOT NULL
);

-- The texts that the task is made of: its own first, then those it imports and extends.
CREATE TABLE source (
  id INTEGER PRIMARY KEY,
  file TEXT NOT NULL,
  text TEXT NOT NULL
);

-- The named parts of the reward, in the order of the plugin.
CREATE TABLE term (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  doc TEXT NOT NULL
);

CREATE TABLE metric (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  reduction TEXT NOT NULL,  -- last, sum, max, min or mean
  doc TEXT NOT NULL
);

CREATE TABLE log (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  reduction TEXT NOT NULL,  -- last, sum, max, min or mean
  doc TEXT NOT NULL
);

-- Numbered from 1. A value that is not a number is NULL.
CREATE TABLE episode (
  number INTEGER PRIMARY KEY,
  return REAL,
  end_kind TEXT NOT NULL,   -- success, failure, truncated or diverged
  end_reason TEXT NOT NULL,
  steps INTEGER NOT NULL,   -- control steps
  actions INTEGER NOT NULL,
  simulated_seconds REAL NOT NULL,
  wall_seconds REAL NOT NULL,
  faults INTEGER NOT NULL,  -- reward values that were not finite and so not paid
  violations INTEGER NOT NULL  -- callbacks in which something that the task requires did not hold
);

CREATE TABLE episode_term (
  episode INTEGER NOT NULL REFERENCES episode ON DELETE CASCADE,
  term INTEGER NOT NULL REFERENCES term,
  sum REAL,
  PRIMARY KEY (episode, term)
) WITHOUT ROWID;

CREATE TABLE episode_metric (
  episode INTEGER NOT NULL REFERENCES episode ON DELETE CASCADE,
  metric INTEGER NOT NULL REFERENCES metric,
  value REAL,
  PRIMARY KEY (episode, metric)
) WITHOUT ROWID;

CREATE TABLE episode_log (
  episode INTEGER NOT NULL REFERENCES episode ON DELETE CASCADE,
  log INTEGER NOT NULL REFERENCES log,
  value REAL,               -- NULL where nothing was logged
  PRIMARY KEY (episode, log)
) WITHOUT ROWID;

-- `poses`: zstd of little-endian float32 [frames][links][7]: x y z qw qx qy qz of each link's frame
-- at its centre, world frame.
CREATE TABLE recording (
  episode INTEGER PRIMARY KEY REFERENCES episode ON DELETE CASCADE,
  is_best INTEGER NOT NULL,       -- 1: the highest return up to then
  frames INTEGER NOT NULL,
  frame_interval REAL NOT NULL,
  poses BLOB NOT NULL
);

-- All that is needed to go on after `episode`: zstd of the modules' state (checkpoint.h).
CREATE TABLE checkpoint (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  episode INTEGER NOT NULL,
  state BLOB NOT NULL
);
