% RUNFOLDERSOF  Run folders of a model that a case must look into.
%
% CALL: NAMES = runFoldersOf (CASE, MODEL)         those of this case
%       NAMES = runFoldersOf (CASE, MODEL, JOBS)   those with their keys
%
%   CASE   see newCase;  MODEL  name of the model (text)
%   JOBS   1 x n struct array, see newJobs
%   NAMES  n x 1 cell; all where Input.store is the case folder, else without
%          those that the index of the store knows to be of another case, or of
%          another key
%
% See also: listRunFolders, readLibrary, findRuns, runsOfCase

function names = runFoldersOf (Case, model, jobs)
  names = listRunFolders (Case.store, model);
  k = strcmp (model, {Case.models.name});
  if strcmp (Case.store, Case.folder) || ~isfolder (Case.models(k).folder)
    return
  end
  h = hashModels (Case)(k);
  kinds = readLibrary (Case.store, model, h);
  if nargin > 2
    heads = headsOf (jobs, Case, h);
  end
  other = zeros (0, 1);
  for kind = kinds
    isOther = ~any (strcmp (kind.origin, {'', Case.folder})) && ...
              kind.origin(1) ~= '?';
    if nargin > 2
      isOther = ~ismember (kind.runs(:, 3), heads);
    end
    other = [other; kind.runs(isOther & true (rows (kind.runs), 1), 1)];
  end
  names = names(~ismember (str2double (names), other));
end

% First digits of the keys, also of those that earlier versions gave.
function heads = headsOf (jobs, Case, h)
  heads = [];
  for job = jobs
    [~, older] = runKey (runVariables (job, Case), Case.effectVars, h);
    heads(end + 1) = sscanf (job.key(1:7), '%x');
    if ~isempty (older)
      heads(end + 1) = sscanf (older(1:7), '%x');
    end
  end
end

%!test
%! first = newCase (standInCase (tempname ()));
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
