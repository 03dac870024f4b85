% TABLEOFRECORDS  Run records of a campaign as the table that exportRuns takes.
%
% CALL: DATA = tableOfRecords (PLAN, RECORDS, CASE)
%
%   PLAN     struct with X (n x d), E (n x v), replicate (n x 1)
%   RECORDS  n x M struct array, see newRecord
%   CASE     see newCase
%   DATA     see exportRuns; a run that ended may have all of its results, some
%            or none of them
%
% See also: campaign

function data = tableOfRecords (plan, records, Case)
  data = struct ('X', plan.X, 'E', plan.E, 'replicate', plan.replicate);
  data.Z = NaN (rows (plan.X), numel (Case.targets));
  data.ended = ismember (reshape ({records.status}, size (records)), ...
                         {'ok', 'invalid'});
  data.seed = reshape ([records.seed], size (records));
  for t = 1:numel (Case.targets)
    target = Case.targets(t);
    for i = find (data.ended(:, target.model))'
      results = records(i, target.model).results;
      if numel (results) >= target.index
        data.Z(i, t) = results(target.index);
      end
    end
  end
end
