% RUNFOLDERSOF  Run folders of a model that a case must look into.
%
% CALL: NAMES = runFoldersOf (CASE, MODEL)           those of this case
%       NAMES = runFoldersOf (CASE, MODEL, JOBS)     those with their keys
%       NAMES = runFoldersOf (CASE, MODEL, 'model')  those of the same model
%
%   CASE   see newCase;  MODEL  name of the model (text)
%   JOBS   1 x n struct array, see newJobs
%   NAMES  n x 1 cell; all where Input.store is the case folder, else without
%          those of which the index of the store knows that they are others, or
%          (of the model) have no result

function names = runFoldersOf (Case, model, jobs)
  place = runPlace (Case, model);
  names = listRunFolders (place);
  k = strcmp (model, {Case.models.name});
  if ~sharesStore (Case) || ~isfolder (Case.models(k).folder)
    return
  end
  h = hashModels (Case)(k);
  isOther = @(kind) ~isOwnRun (kind, Case);
  if nargin > 2 && ischar (jobs)
    isOther = @(kind) ~strcmp (kind.input, h.input) | ...
                      ~ismember (kind.runs(:, 2), [1, 2]);
  elseif nargin > 2
    heads = cellfun (@(key) sscanf (key(1:7), '%x'), {jobs.key});
    isOther = @(kind) ~ismember (kind.runs(:, 3), heads);
  end
  other = zeros (0, 1);
  for kind = readLibrary (place)
    if nargin > 2 || ~isempty (kind.origin)
      other = [other; kind.runs(isOther (kind) & kind.runs(:, 1) > 0, 1)];
    end
  end
  names = names(~ismember (str2double (names), other));
end

%!test
%! first = readyCase ();
%! evaluateDEM ([1, 2; 3, 4], first);
%! raw = standInCase (tempname ());
%! raw.Input.store = first.store;
%! Case = newCase (raw);
%! evaluateDEM ([5, 6], Case);
%! assert (runFoldersOf (first, 'First'), {'0001'; '0002'; '0003'});
%! assert (runFoldersOf (Case, 'First'), {'0003'});
%! job = newJobs (Case, [3, 4], [], 1, 'plan')(1);
%! assert (numel (runFoldersOf (Case, 'First', job)), 1);
%! assert (findRuns (job, Case){1}.results, [7, 12], 1e-12);
%! % of the same model: whoever made them, with a result
%! assert (numel (runFoldersOf (Case, 'First', 'model')), 3);
%! head = fullfile (Case.models(1).folder, 'data.head');
%! writeAtomic (head, [fileread(head), "\n"]);
%! assert (isempty (runFoldersOf (Case, 'First', 'model')));
%! assert (runFoldersOf (Case, 'First'), {'0003'});

% SPDX-License-Identifier: GPL-3.0-only
