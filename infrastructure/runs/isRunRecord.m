% ISRUNRECORD  Tells whether what a store holds is the job or record of a run.
%
% CALL: YES = isRunRecord (R)
%
%   R    what readRecord gave
%   YES  logical: all fields of a job are there, each of its kind; so are those
%        of a record, where it has a status (see newJobs, newRecord)
%
% Others may write to a store: a checksum proves that a file is whole, not that
% it is sane.

function yes = isRunRecord (r)
  yes = isstruct (r) && isscalar (r) && ...
        hasTexts (r, {'model', 'stage', 'key'}) && ...
        hasNumbers (r, {'planRow', 'replicate', 'seed'}, true) && ...
        hasNumbers (r, {'params', 'effects'}, false);
  yes = yes && hasOrigin (r) && ...
        (~isfield (r, 'status') || ...
         (hasReading (r) && hasNumbers (r, {'seconds'}, true))) && ...
        (~isfield (r, 'readings') || ...
         (isstruct (r.readings) && ...
          all (arrayfun (@hasReading, r.readings(:)))));
end

% Versions until 0.9.0 noted the key alone.
function yes = hasOrigin (r)
  yes = numel (r.key) == 64 && all (isxdigit (r.key));
  yes = yes && (~isfield (r, 'variables') || ...
                (hasTexts (r, {'input', 'variables', 'origin'}) && ...
                 (isempty (r.variables) || ...
                  ~isempty (regexp (r.variables, '^(\|\w+=[^|\s]+)+$', ...
                                    'once')))));
  yes = yes && (~isfield (r, 'owner') || ...
                (hasTexts (r, {'owner'}) && ...
                 any (numel (r.owner) == [0, 32]) && ...
                 all (isxdigit (r.owner))));
end

function yes = hasReading (r)
  yes = hasTexts (r, {'status', 'message', 'cause'}) && ...
        hasNumbers (r, {'results'}, false) && ...
        (~isfield (r, 'funs') || hasTexts (r, {'funs'}));
end

% Loops, as cellfun with a function handle takes ten times as long, and a store
% may hold 100,000 records.
function yes = hasTexts (r, names)
  yes = all (isfield (r, names));
  for name = names(1:end * yes)
    value = r.(name{1});
    yes = yes && ischar (value) && rows (value) <= 1;
  end
end

function yes = hasNumbers (r, names, isOne)
  yes = all (isfield (r, names));
  for name = names(1:end * yes)
    value = r.(name{1});
    yes = yes && isnumeric (value) && rows (value) <= 1 && ...
          (~isOne || numel (value) == 1);
  end
end

%!shared Case, job, r
%! Case = newCase (standInCase (tempname ()));
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! r = setfield (newRecord (job, 'f'), 'results', [1, 2]);
%!assert (isRunRecord (job))
%!assert (isRunRecord (r))
%!assert (isRunRecord (rmfield (r, {'input', 'variables', 'origin'})))
%!test
%! % one of an old version that was read anew: a finished run was lost
%! old = rmfield (job, {'input', 'variables', 'origin'});
%! file = tempname ();
%! writeRecord (file, newRecord (old, ''));
%! assert (isRunRecord (readRecord (file)));
%!test
%! bad = {'key', 'x', 'seed', [], 'seed', [1, 2], 'results', 'x', ...
%!        'status', 5, 'seconds', [], 'variables', 'a=1', 'variables', ...
%!        '|a=1|b', 'origin', 5, 'params', [1; 2], 'readings', 5, ...
%!        'readings', struct('status', 'ok'), 'owner', 1, ...
%!        'owner', 'x'};
%! for k = 1:2:numel (bad)
%!   assert (! isRunRecord (setfield (r, bad{k:k + 1})), bad{k});
%! end
%! for bad = {[], 5, 'x', {}, struct(), [r, r], rmfield(job, 'key')}
%!   assert (! isRunRecord (bad{1}));
%! end
