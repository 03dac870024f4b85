% EVALUATEDEM  Evaluates the DEM models at parameter sets.
%
% CALL: RESULTS = evaluateDEM (PARAMS)
%       [Z, RECORDS, ISREUSED, NNEW, MODELS] = ...
%         evaluateDEM (P, CASE, REPLICATE, STAGE, REPORT, E)
%
%   PARAMS     1 x d or d x 1, one set; the call handed to costFunction
%   RESULTS    T x 1, one row a target; NaN where a run failed
%   P          n x d parameter sets
%   CASE       see newCase (default: the case of the current folder)
%   REPLICATE  n x 1 or scalar, number of the replicate (default 1)
%   STAGE      what the runs are for (text, default 'verify')
%   REPORT     function handle for the progress (default: silent)
%   E          n x v levels and effect values, as effectVars (default: neutral)
%   Z          n x T, one column a target of CASE.targets
%   RECORDS    n x M struct array, see newRecord
%   ISREUSED   n x M logical: the run was in the store
%   NNEW       runs that were made
%   MODELS     CASE.models, which knows how long these runs took
%
% All runs go to the executor together. Finished runs are used again.
%
% See also: evaluateKriging, runJobs, costFunction

function [Z, records, isReused, nNew, models] = evaluateDEM (P, varargin)
  given = {[], 1, 'verify', @(state) [], []};
  given(1:numel (varargin)) = varargin;
  [Case, replicate, stage, report, E] = given{:};
  isPublishedCall = ~isstruct (Case);
  if isPublishedCall
    Case = loadCase ();
    P = P(:)';
  end
  if rows (P) == 0
    Z = zeros (0, numel (Case.targets));
    [records, isReused, nNew] = deal ([], false (0, numel (Case.models)), 0);
    models = Case.models;
    return
  end
  Case.hashes = hashModels (Case);
  jobs = newJobs (Case, P, E, replicate, stage);
  [records, isReused, nNew, models] = runJobs (jobs, Case, report);
  records = reshape (records, numel (Case.models), rows (P)).';
  isReused = reshape (isReused, numel (Case.models), rows (P)).';
  Z = NaN (rows (P), numel (Case.targets));
  for t = 1:numel (Case.targets)
    target = Case.targets(t);
    isOk = strcmp ({records(:, target.model).status}, 'ok');
    for i = find (isOk)
      Z(i, t) = records(i, target.model).results(target.index);
    end
  end
  if isPublishedCall
    Z = Z(:);
  end
end

%!test
%! Case = readyCase ();
%! [Z, r] = evaluateDEM ([1, 2; 3, 4], Case);
%! assert (Z, [3, 2, -1; 7, 12, -1], 1e-12);
%! assert (size (r), [2, 2]);
%! [Z, r, isReused, nNew] = evaluateDEM (zeros (0, 2), Case);
%! assert ({Z, r, nNew}, {zeros(0, 3), [], 0});
%!test
%! % a model that fails gives NaN in its own columns only, and is tried with
%! % another seed once
%! Case = readyCase ();
%! writeAtomic (fullfile (Case.models(2).folder, 'runscript'), "exit 1\n");
%! Z = evaluateDEM ([1, 2], Case);
%! assert (Z, [3, 2, NaN], 1e-12);
%! assert (numel (listRunFolders (Case.store, 'Second')), 2);

% SPDX-License-Identifier: GPL-3.0-only
