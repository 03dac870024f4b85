% YADERUNS  Makes the runs of a table with the benches in YADE or LIGGGHTS.
%
% CALL: TABLE = yadeRuns (FILE, OUT, WORK)
%
% FILE   text, a table of runs: a line a run, a column model (Collapse or
%        Heap), optionally seed (default 10007) and code (yade or liggghts;
%        default yade), and a column per variable of data.head, effects among
%        them; an empty field leaves a variable as it is
% OUT    text, the table that is written: the columns of FILE, seconds (CPU
%        time of the run) and a column per result of the benches, by the names
%        of examples/hiddenEffect (those of results.csv, but collapseSlope,
%        heapSlope and heapHeight); empty where a result does not belong to the
%        model, NaN where the run is not sane
% WORK   text, folder of the runs; finished ones that lie there are taken
% TABLE  cell, what was written, its first row the header
%
% Two runs at a time on two CPUs.
%
% Throws DEcalioc:yadeRuns:missingField, DEcalioc:yadeRuns:unknownName.
%
% See also: benchRun
function table = yadeRuns (file, out, work)
  [header, cells] = readCsvTable (file);
  if ~ismember ('model', header)
    error ('DEcalioc:yadeRuns:missingField', ...
           'yadeRuns: %s must have a column model, got %s.', file, ...
           strjoin (header, ', '));
  end
  jobs = cellfun (@(k) jobOf (header, cells(k, :), work), ...
                  num2cell (1:rows (cells)), 'UniformOutput', false);
  [results, seconds] = parcellfun (nproc (), @runOne, jobs, ...
                                   'UniformOutput', false, 'VerboseLevel', 0);
  names = cellfun (@namesOf, {'Collapse', 'Heap'}, 'UniformOutput', false);
  names = [names{:}];
  filled = repmat ({''}, rows (cells), numel (names));
  for k = 1:rows (cells)
    [~, at] = ismember (namesOf (jobs{k}.bench), names);
    filled(k, at) = arrayfun (@(x) sprintf ('%.6g', x), results{k}, ...
                              'UniformOutput', false);
  end
  seconds = cellfun (@(s) sprintf ('%.3g', s), seconds(:), ...
                     'UniformOutput', false);
  table = [header(:).', {'seconds'}, names; cells, seconds, filled];
  lines = cellfun (@(k) strjoin (table(k, :), ','), ...
                   num2cell (1:rows (table)), 'UniformOutput', false);
  writeAtomic (out, sprintf ("%s\n", lines{:}));
end

function [results, seconds] = runOne (job)
  [results, seconds] = benchRun (job.folder, job.model, job.set);
end

% where a run is made, of which model, with which variables
function job = jobOf (header, fields, work)
  given = cell2struct (fields(:), header(:), 1);
  code = 'yade';
  if isfield (given, 'code') && ~isempty (given.code)
    code = given.code;
  end
  job.bench = given.model;
  job.model = modelOf (code, given.model);
  job.set = struct ('runSeed', 10007);
  for name = setdiff (header(:).', {'model', 'code', 'seed'})
    if ~isempty (given.(name{1}))
      job.set.(name{1}) = str2double (given.(name{1}));
    end
  end
  if isfield (given, 'seed') && ~isempty (given.seed)
    job.set.runSeed = str2double (given.seed);
  end
  text = [job.model, sprintf('|%s', fields{:}, header{:})];
  job.folder = fullfile (work, [given.model, '-', code, '-', ...
                                hash('md5', text)(1:12)]);
end

% a name of DEMmodels, or the folder of a model of YADE
function model = modelOf (code, bench)
  here = fileparts (mfilename ('fullpath'));
  root = fileparts (fileparts (fileparts (here)));
  ofYade.Collapse = fullfile (root, 'examples', 'yade', 'DEMmodels', ...
                              'YadeCollapse');
  ofYade.Heap = fullfile (here, 'DEMmodels', 'YadeHeap');
  if ~isfield (ofYade, bench) || ~ismember (code, {'yade', 'liggghts'})
    error ('DEcalioc:yadeRuns:unknownName', ...
           ['yadeRuns: model must be Collapse or Heap and code yade or ' ...
            'liggghts, got %s and %s.'], bench, code);
  end
  model = bench;
  if strcmp (code, 'yade')
    model = ofYade.(bench);
  end
end

function names = namesOf (bench)
  names = {resultInfo(modelOf ('yade', bench)).name};
  shared = ismember (names, {'slope', 'height'});
  names(shared) = cellfun (@(n) [lower(bench), upper(n(1)), n(2:end)], ...
                           names(shared), 'UniformOutput', false);
end
