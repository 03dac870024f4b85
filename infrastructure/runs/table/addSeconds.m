% ADDSECONDS  Notes how long finished runs of each model took.
%
% CALL: MODELS = addSeconds (MODELS, RECORDS)
%
%   MODELS   1 x M struct array, Case.models; to its field seconds the seconds
%            of the model's records that ended well are appended, and those of
%            the ones that were cut off at their time limit with a minus: they
%            would have taken longer; of a case with
%            levels those at the last one: coarse runs say nothing of how long a
%            fine one may take
%   RECORDS  1 x n struct array, see newRecord

function models = addSeconds (models, records)
  isCut = strcmp ({records.status}, 'timeout');
  isKnown = isCut | strcmp ({records.status}, 'ok');
  sign = num2cell (1 - 2 * isCut .* ones (1, numel (records)));
  [records.sign] = sign{:};
  for k = 1:numel (models)
    mine = isKnown & strcmp ({records.model}, models(k).name);
    mine(mine) = arrayfun (@(r) atLastLevel (r.effects, models(k)), records(mine));
    models(k).seconds = [models(k).seconds, ...
                         [records(mine).seconds] .* [records(mine).sign]];
  end
end

%!test
%! models = struct ('name', {'A', 'B'}, 'seconds', {[], 7}, 'coarse', []);
%! records = struct ('model', {'A', 'A', 'B'}, 'seconds', {1, 2, 3}, ...
%!                   'status', {'ok', 'timeout', 'ok'}, 'effects', []);
%! models = addSeconds (models, records);
%! assert ({models.seconds}, {[1, -2], [7, 3]});

%!test
%! % of a case with levels only the runs at the last one count
%! model = struct ('name', 'a', 'seconds', 5, ...
%!                 'coarse', struct ('levels', [3, 1]));
%! run = @(e, s) struct ('model', 'a', 'status', 'ok', 'effects', e, ...
%!                       'seconds', s);
%! known = addSeconds (model, [run(3, 1), run(1, 7), run([], 9)]);
%! assert (known.seconds, [5, 7, 9]);

% SPDX-License-Identifier: GPL-3.0-only
