% FORGETRUNS  Takes runs of a store out of use, or into use again.
%
% CALL: [CHANGED, LATER] = forgetRuns (STORE, MODEL, WHICH, ISBACK)
%
%   STORE    folder that holds optim/ (text);  MODEL  its name (text)
%   WHICH    n x 2, first and last number of runs; or {NAME, FOLDER}, all runs of a
%            case, as the user named it and its full path
%   ISBACK   true: into use again (logical)
%   CHANGED  1 x n cell of MODEL/NUMBER; LATER  as CHANGED, runs that started from
%            them
%
% A run that is forgotten has the status 'forgotten' in its record, and that
% alone has changed: it counts in no case, and its folder stays. Where a case
% needs it, a run with another seed takes its place (runJobs). Runs that started
% from its last state (stagesOf) go with it, and come back with it, not without it.
%
% Errors: DEcalioc:forgetRuns:badValue (several cases were at that folder; one that is to
% come back started from a run that stays out of use)

function [changed, later] = forgetRuns (store, model, which, isBack)
  if iscell (which)
    chosen = runsOfCases (readLibrary (fullfile (store, 'optim', model)), which{:});
  else
    chosen = str2double (listRunFolders (store, model));
    chosen = chosen(any (chosen >= which(:, 1)' & chosen <= which(:, 2)', 2));
  end
  name = @(number) fullfile (model, sprintf ('%04d', number));
  runs = arrayfun (name, unique (chosen)', 'UniformOutput', false);
  if isBack
    refuseLater (store, runs);
  end
  changed = markedRuns (store, runs, isBack);
  later = setdiff (startedFrom (store, changed), changed);
  later = markedRuns (store, later, isBack);
end

function refuseLater (store, runs)
  folder = fullfile (store, 'optim');
  for run = runs
    place = regexprep (fullfile (folder, run{1}), '([][*?\\])', '\\$1');
    to = cellfun (@readlink, glob (fullfile (place, '*'))', 'UniformOutput', false);
    starts = regexprep (to(strncmp (to, '../../', 6)), '^\.\./\.\./', '');
    for start = setdiff (starts, runs)
      r = readSane (fullfile (folder, start{1}, 'record.json'));
      if isfield (r, 'status') && strcmp (r.status, 'forgotten')
        error ('DEcalioc:forgetRuns:badValue', ...
               ['decalioc forget: the run that %s started from must be in use, got %s ' ...
                'out of use. Take that in again, its own come back with it.'], run{1}, ...
               start{1});
      end
    end
  end
end

% Those of RUNS (1 x n cell of MODEL/NUMBER) of which the mark was changed.
function changed = markedRuns (store, runs, isBack)
  isChanged = cellfun (@(run) marked (fullfile (store, 'optim', run), isBack), runs);
  changed = runs(isChanged);
end

% Runs that hold the last state of one of RUNS, and those that hold theirs: a link
% of the name of its model (prepareRun).
function later = startedFrom (store, runs)
  later = cell (1, 0);
  runs_ = fullfile (regexprep (store, '([][*?\\])', '\\$1'), 'optim', '*', '*');
  while ~isempty (runs)
    new = cell (1, 0);
    for model = unique (cellfun (@fileparts, runs, 'UniformOutput', false))
      links = glob (fullfile (runs_, model{1}))';
      to = cellfun (@readlink, links, 'UniformOutput', false);
      isOne = ismember (to, strcat ('../../', runs));
      new = [new, regexprep(links(isOne), '^.*/optim/([^/]+/[^/]+)/[^/]+$', '$1')];
    end
    runs = setdiff (new, later);
    later = [later, runs(:)'];
  end
end

% The case is named by its folder, as decalioc runs does or by its full path, or
% by the first digits of its id. Runs of a case without an id have no owner.
function chosen = runsOfCases (kinds, name, folder)
  folders = {name, folder, canonicalize_file_name(folder)};
  isAt = ismember ({kinds.origin}, folders) & ~strcmp ({kinds.origin}, '');
  hasOwner = ~strcmp ({kinds.owner}, '');
  id = caseId (folder);
  if isempty (id) && ~isempty (regexp (name, '^[0-9a-f]{8,32}$', 'once'))
    id = name;
  end
  if ~isempty (id)
    isOf = strncmp ({kinds.owner}, id, numel (id));
  else
    isOf = isAt & hasOwner;
    owners = unique ({kinds(isOf).owner});
    if numel (owners) > 1
      error ('DEcalioc:forgetRuns:badValue', ...
             ['decalioc forget: --case must name one case, got %s, at which ' ...
              '%d cases have been (containers?). Name one by its id: %s'], ...
             name, numel (owners), ...
             strjoin (cellfun (@(o) o(1:min (8, end)), owners, ...
                               'UniformOutput', false), ', '));
    end
  end
  isOf = isOf | (isAt & ~hasOwner);
  chosen = vertcat (zeros (0, 1), cellfun (@(r) r(:, 1), {kinds(isOf).runs}, ...
                                           'UniformOutput', false){:});
end

% Writes the mark into the record, or takes it out.
function done = marked (folder, isBack)
  file = fullfile (folder, 'record.json');
  r = readSane (file);
  done = isfield (r, 'status') && strcmp (r.status, 'forgotten') == isBack;
  if ~done
    return
  end
  if isBack
    [r.status, r.message] = beforeForgotten (r.message);
  else
    r.message = sprintf ('was %s. %s', r.status, r.message);
    r.status = 'forgotten';
  end
  writeRecord (file, r);
end

%!test
%! Case = readyCase ();
%! evaluateDEM ([1, 2; 3, 4; 5, 6], Case);
%! status = @() cellfun (@(r) r.status, findRuns (newJobs (Case, [1, 2; 3, 4; 5, 6], ...
%!                                                         [], 1, 'plan')(1:2:end), ...
%!                                                Case), 'UniformOutput', false);
%! [changed, later] = forgetRuns (Case.store, 'First', [2, 9], false);
%! assert (changed, {'First/0002', 'First/0003'});
%! assert (isempty (later));
%! assert (status (), {'ok', 'forgotten', 'forgotten'});
%! assert (isempty (forgetRuns (Case.store, 'First', [2, 9], false)));
%! % one that started from a run that stays out of use does not come back
%! symlink ('../../First/0002', fullfile (Case.store, 'optim', 'Second', '0001', 'First'));
%! [~, ~] = forgetRuns (Case.store, 'First', [2, 2], true);
%! [~, later] = forgetRuns (Case.store, 'First', [2, 2], false);
%! assert (later, {'Second/0001'});
%! fail ('forgetRuns (Case.store, ''Second'', [1, 1], true)', 'got First/0002 out of use');
%! forgetRuns (Case.store, 'First', {'x', Case.folder}, true);
%! assert (status (), {'ok', 'ok', 'ok'});

% SPDX-License-Identifier: GPL-3.0-only
