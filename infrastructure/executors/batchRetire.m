% BATCHRETIRE  Removes the batch folders that nobody needs any more.
%
% CALL: FLIGHT = batchRetire (FLIGHT)
%       FLIGHT = batchRetire (FLIGHT, B)
%
%   FLIGHT  see batchAttach; a batch goes when none of its runs is open
%   B       index of a batch that the queue refused: its runs are given up

function flight = batchRetire (flight, b)
  if nargin > 1
    isOurs = flight.batch == b & flight.status == 'o';
    cellfun (@batchVoid, flight.folder(isOurs));
    batchDiscard (flight.batches(b).path);
    return
  end
  isHeld = flight.status == 'o' | flight.status == 'e';
  held = unique (flight.batch(isHeld));
  for b = setdiff (unique (flight.batch(flight.batch > 0)), held)
    isGone = flight.batch == b;
    if flight.batches(b).left == sum (isGone)
      batchDiscard (flight.batches(b).path);
    end
    flight.batch(isGone) = 0;
  end
end

%!test
%! store = tempname ();
%! mkdir (fullfile (store, 'a'));
%! mkdir (fullfile (store, 'b'));
%! f = struct ('status', 'sso', 'batch', [1, 1, 2]);
%! f.batches = struct ('path', {[store, '/a'], [store, '/b']}, 'left', {2, 2});
%! f = batchRetire (f);
%! assert (f.batch, [0, 0, 2]);
%! assert (readdir (store), {'.'; '..'; 'b'});
%! % one more run of b belongs to nobody here: its folder stays
%! f.status = 'sss';
%! f = batchRetire (f);
%! assert (readdir (store), {'.'; '..'; 'b'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (store, 's');
