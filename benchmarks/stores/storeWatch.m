% STOREWATCH  What a store of several cases holds, and what of it was harmed.
%
% CALL: NOW = storeWatch (STORE)
%       [NOW, FAULTS] = storeWatch (STORE, BEFORE, HITS)
%
%   STORE   folder that holds optim/ (text)
%   BEFORE  NOW of an earlier look
%   HITS    1 x h struct array: owner (id of a case), time (s, when it was last
%           killed or cancelled by its own user)
%   NOW     1 x n struct array: folder, owner, key, status ('' before there is a
%           record), answers (k x 2 cell: digest of a question, results),
%           isKilled (it was ended from outside), made (s, time of job.json)
%   FAULTS  struct of three 1 x f cells of texts: lost (a record that was there
%           is gone, cannot be read, is another run's or no longer gives an
%           answer that it gave), touched (a run that was ended though its case
%           was not hit since it was made), repeated (a run that was made twice
%           though the first had ended well)
%
% See also: twoUsers

function [now, faults] = storeWatch (store, before, hits)
  now = struct ('folder', {}, 'owner', {}, 'key', {}, 'status', {}, ...
                'answers', {}, 'isKilled', {}, 'made', {});
  for folder = glob (fullfile (store, 'optim', '*', '[0-9]*'))'
    run = oneRun (folder{1});
    if ~isempty (run)
      now(end + 1) = run;
    end
  end
  faults = struct ('lost', {{}}, 'touched', {{}}, 'repeated', {{}});
  if nargin > 1
    faults.lost = lostOf (now, before);
    faults.touched = touchedOf (now, hits);
    faults.repeated = repeatedOf (now);
  end
end

function run = oneRun (folder)
  run = [];
  job = readRecord (fullfile (folder, 'job.json'));
  s = stat (fullfile (folder, 'job.json'));
  if ~isRunRecord (job)
    return                               % it is being made
  end
  r = readRecord (fullfile (folder, 'record.json'));
  run = struct ('folder', folder, 'owner', givenField (job, 'owner', ''), ...
                'key', job.key, 'status', '', 'answers', {cell(0, 2)}, ...
                'isKilled', false, 'made', s.mtime);
  mark = readEndMark (folder);
  run.isKilled = strcmp (givenField (mark, 'reason', ''), 'killed');
  if ~isRunRecord (r)
    return
  end
  [run.status, run.key] = deal (r.status, r.key);
  run.isKilled = run.isKilled || strcmp (r.cause, 'killed');
  readings = num2cell (givenField (r, 'readings', [])(:)');
  for reading = [{r}, readings]
    run.answers(end + 1, :) = {givenField(reading{1}, 'funs', ''), ...
                               reading{1}.results};
  end
end

function texts = lostOf (now, before)
  texts = {};
  before = before(ismember ({before.status}, {'ok', 'forgotten'}));
  for old = before
    new = now(strcmp ({now.folder}, old.folder));
    if isempty (new) || ~any (strcmp (new.status, {'ok', 'forgotten'}))
      texts{end + 1} = [old.folder, ': no result any more'];
    elseif ~strcmp (new.key, old.key) || ~strcmp (new.owner, old.owner)
      texts{end + 1} = [old.folder, ': of another run or case'];
    else
      isSame = @(k) any (cellfun (@(f, z) isequal ({f, z}, ...
                                                   old.answers(k, :)), ...
                                  new.answers(:, 1), new.answers(:, 2)));
      if ~all (arrayfun (isSame, 1:rows (old.answers)))
        texts{end + 1} = [old.folder, ': gives another answer'];
      end
    end
  end
end

function texts = touchedOf (now, hits)
  texts = {};
  for run = now([now.isKilled])
    hit = hits(strcmp ({hits.owner}, run.owner));
    if isempty (hit) || run.made > hit.time
      texts{end + 1} = [run.folder, ': ended from outside'];
    end
  end
end

function texts = repeatedOf (now)
  now = now(strcmp ({now.status}, 'ok'));
  [~, ~, which] = unique ({now.key});
  isTwice = accumarray (which(:), 1)(which(:)) > 1;
  texts = {now(isTwice).folder};
end

%!shared Case, store, none
%! Case = newCase (standInCase (tempname ()));
%! evaluateDEM ([1, 2; 3, 4], Case);
%! store = Case.store;
%! none = struct ('owner', {}, 'time', {});
%!function file = recordOf (store, n, name)
%!  file = fullfile (store, 'optim', 'First', sprintf ('%04d', n), name);
%!endfunction
%!test
%! % as it is; taken out of use is not lost; another answer is kept beside
%! before = storeWatch (store);
%! assert ({before.status}, repmat ({'ok'}, 1, 4));
%! file = recordOf (store, 1, 'record.json');
%! r = readRecord (file);
%! keepRecord (setfield (setfield (r, 'funs', 'g'), 'results', 7));
%! writeRecord (recordOf (store, 2, 'record.json'), ...
%!              setfield (readRecord (recordOf (store, 2, 'record.json')), ...
%!                        'status', 'forgotten'));
%! [now, faults] = storeWatch (store, before, none);
%! assert (struct2cell (faults), {{}; {}; {}});
%! % lost: gone, another run's, another answer
%! for bad = {[], setfield(r, 'key', repmat ('a', 1, 64)), ...
%!            setfield(r, 'results', [0, 0])}
%!   [~, ~] = unlink (file);
%!   if ~isempty (bad{1})
%!     writeRecord (file, bad{1});
%!   end
%!   [~, faults] = storeWatch (store, before, none);
%!   assert (numel (faults.lost), 1);
%! end
%! writeRecord (file, r);
%! % made twice; ended though nobody has hit the case since
%! copyfile (fileparts (file), recordOf (store, 9, ''));
%! writeAtomic (recordOf (store, 2, 'end.mark'), "143 1.0 killed\n");
%! [now, faults] = storeWatch (store, before, none);
%! assert (numel (faults.repeated), 2);
%! assert (numel (faults.touched), 1);
%! hits = struct ('owner', caseId (Case.folder), 'time', time () + 1);
%! [~, faults] = storeWatch (store, before, hits);
%! assert (faults.touched, {});
