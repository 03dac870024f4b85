% ADDSECONDS  Notes how long finished runs of each model took.
%
% CALL: MODELS = addSeconds (MODELS, RECORDS)
%
%   MODELS   1 x M struct array, Case.models; to its field seconds the seconds
%            of the model's records that ended well are appended
%   RECORDS  1 x n struct array, see newRecord
%
% See also: defaultLimit, newEvaluate

function models = addSeconds (models, records)
  isOk = strcmp ({records.status}, 'ok');
  for k = 1:numel (models)
    mine = isOk & strcmp ({records.model}, models(k).name);
    models(k).seconds = [models(k).seconds, records(mine).seconds];
  end
end

%!test
%! models = struct ('name', {'A', 'B'}, 'seconds', {[], 7});
%! records = struct ('model', {'A', 'A', 'B'}, 'seconds', {1, 2, 3}, ...
%!                   'status', {'ok', 'timeout', 'ok'});
%! models = addSeconds (models, records);
%! assert ({models.seconds}, {1, [7, 3]});
