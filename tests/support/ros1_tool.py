#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes messages with ROS 1's own Python modules (Debian: python3-rosbag), as a judge of what
reads them, and publishes and receives them (python3-roslaunch).

    ros1_tool.py check | check_live
    ros1_tool.py wait_master
    ros1_tool.py bag LIST OUT none|bz2|lz4 [unclosed]
    ros1_tool.py raw LIST FOLDER
    ros1_tool.py publish LIST RATE exit|stay|again  stay: the node runs on when all was published;
                                                again: it begins again, with later stamps
    ros1_tool.py listen PREFIX OUT              until it is killed; a line for each message

LIST has a message a line; times are ns, and numbers are taken to the last digit:

    image TOPIC STAMP WIDTH HEIGHT ENCODING FILE    FILE has the bytes of the pixels
    compressed TOPIC STAMP FORMAT FILE
    camera TOPIC STAMP WIDTH HEIGHT MODEL COUNT D... K(9) R(9) P(12)
    imu TOPIC STAMP angular(3) linear(3)
    odometry TOPIC STAMP x y theta
    string TOPIC STAMP TEXT
"""
import math
import os
import sys
import time


def time_of(stamp):
    import genpy

    return genpy.Time(int(stamp) // 1000000000, int(stamp) % 1000000000)


def image(width, height, encoding, file):
    from sensor_msgs.msg import Image

    with open(file, "rb") as stream:
        pixels = stream.read()
    return Image(
        height=int(height), width=int(width), encoding=encoding, step=len(pixels) // int(height), data=pixels
    )


def compressed(form, file):
    from sensor_msgs.msg import CompressedImage

    with open(file, "rb") as stream:
        return CompressedImage(format=form, data=stream.read())


def camera(width, height, model, count, *rest):
    from sensor_msgs.msg import CameraInfo

    values = [float(value) for value in rest]
    end = int(count)
    return CameraInfo(
        height=int(height),
        width=int(width),
        distortion_model=model,
        D=values[:end],
        K=values[end : end + 9],
        R=values[end + 9 : end + 18],
        P=values[end + 18 :],
    )


def imu(*rest):
    from geometry_msgs.msg import Vector3
    from sensor_msgs.msg import Imu

    values = [float(value) for value in rest]
    return Imu(angular_velocity=Vector3(*values[:3]), linear_acceleration=Vector3(*values[3:]))


def odometry(x, y, theta):
    from nav_msgs.msg import Odometry

    message = Odometry(child_frame_id="base")
    message.pose.pose.position.x = float(x)
    message.pose.pose.position.y = float(y)
    message.pose.pose.orientation.z = math.sin(float(theta) / 2)
    message.pose.pose.orientation.w = math.cos(float(theta) / 2)
    return message


def string(text):
    from std_msgs.msg import String

    return String(data=text)


KINDS = {
    "image": image,
    "compressed": compressed,
    "camera": camera,
    "imu": imu,
    "odometry": odometry,
    "string": string,
}


def messages(path):
    """Topic, message and time of each line."""
    with open(path, encoding="utf-8") as lines:
        for number, line in enumerate(lines):
            kind, topic, stamp, *rest = line.split()
            message = KINDS[kind](*rest)
            if kind != "string":
                message.header.seq = number
                message.header.stamp = time_of(stamp)
                message.header.frame_id = "camera"
            yield topic, message, time_of(stamp)


def write_bag(path, out, compression, *style):
    import rosbag

    # Chunks of a few messages, and images larger than a chunk.
    bag = rosbag.Bag(out, "w", compression=compression, chunk_threshold=2000)
    for topic, message, stamp in messages(path):
        bag.write(topic, message, stamp)
    if "unclosed" in style:  # as one that was killed
        bag.flush()
        os._exit(0)
    bag.close()


def write_raw(path, folder):
    import io

    for number, (_, message, _) in enumerate(messages(path)):
        buffer = io.BytesIO()
        message.serialize(buffer)
        with open(os.path.join(folder, "ros1_%d_%s" % (number, type(message).__name__)), "wb") as out:
            out.write(buffer.getvalue())


def show(listed, publishers, period):
    """Publishes each, waiting a period where the stamp changes."""
    last = None
    for topic, message, stamp in listed:
        if last is not None and stamp != last:
            time.sleep(period)
        last = stamp
        publishers[topic].publish(message)


def repeat(listed):
    """Sets the stamps of images behind the last one, in the distances that they have."""
    images = [message for topic, message, _ in listed if not topic.endswith("camera_info")]
    stamps = [message.header.stamp.to_nsec() for message in images]
    length = stamps[-1] - stamps[0] + (stamps[-1] - stamps[0]) // (len(stamps) - 1)
    for message, stamp in zip(images, stamps):
        message.header.stamp = time_of(stamp + length)


def publish(path, rate, then):
    import rospy

    rospy.init_node("camera", disable_signals=True)
    listed = list(messages(path))
    publishers = {}
    for topic, message, _ in listed:
        latch = topic.endswith("camera_info")
        if topic not in publishers:
            publishers[topic] = rospy.Publisher(topic, type(message), queue_size=1000, latch=latch)
    while any(publisher.get_num_connections() == 0 for publisher in publishers.values()):
        time.sleep(0.02)
    show(listed, publishers, 1 / float(rate))
    while then == "again":
        repeat(listed)
        show(listed, publishers, 1 / float(rate))
    time.sleep(0.5)  # what was published last goes out
    while then == "stay":
        time.sleep(1)
    rospy.signal_shutdown("done")


def listen(prefix, path):
    import rospy
    from geometry_msgs.msg import PoseStamped
    from nav_msgs.msg import Path
    from tf2_msgs.msg import TFMessage
    from visualization_msgs.msg import MarkerArray

    rospy.init_node("listener", disable_signals=True)
    out = open(path, "w", buffering=1, encoding="utf-8")

    def pose(message):
        at, q = message.pose.position, message.pose.orientation
        out.write(
            "pose %s %d %r %r %r %r\n"
            % (message.header.frame_id, message.header.stamp.to_nsec(), at.x, at.y, at.z, q.w)
        )

    def path_of(message):
        out.write("path %s %d\n" % (message.header.frame_id, len(message.poses)))

    def tf(message):
        for item in message.transforms:
            at = item.transform.translation
            out.write(
                "tf %s %s %d %r\n"
                % (item.header.frame_id, item.child_frame_id, item.header.stamp.to_nsec(), at.x)
            )

    def markers(message):
        out.write("map %s\n" % " ".join("%s:%d" % (m.ns, len(m.points)) for m in message.markers))

    kept = [
        rospy.Subscriber(prefix + "/pose", PoseStamped, pose),
        rospy.Subscriber(prefix + "/path", Path, path_of),
        rospy.Subscriber(prefix + "/map", MarkerArray, markers),
        rospy.Subscriber("/tf", TFMessage, tf),
    ]
    out.write("ready\n")
    while kept:
        time.sleep(1)


def check():
    import nav_msgs.msg
    import rosbag
    import sensor_msgs.msg
    import std_msgs.msg

    print(rosbag.__name__, sensor_msgs.msg.__name__, nav_msgs.msg.__name__, std_msgs.msg.__name__)


def wait_master():
    import rosgraph

    while not rosgraph.is_master_online():
        time.sleep(0.1)


def check_live():
    import rospy
    import tf2_msgs.msg
    import visualization_msgs.msg

    print(rospy.__name__, tf2_msgs.msg.__name__, visualization_msgs.msg.__name__)


if __name__ == "__main__":
    commands = {
        "bag": write_bag,
        "raw": write_raw,
        "publish": publish,
        "listen": listen,
        "wait_master": wait_master,
        "check": check,
        "check_live": check_live,
    }
    commands[sys.argv[1]](*sys.argv[2:])
